// VulkanMemoryAllocator with the functions fetched at run time; its implementation is compiled in vma.cpp.
#pragma once

#define VMA_STATIC_VULKAN_FUNCTIONS 0
#define VMA_DYNAMIC_VULKAN_FUNCTIONS 1
#include <vk_mem_alloc.h>
