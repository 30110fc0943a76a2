namespace Unity.Collections;

/// <summary>Whether new memory is cleared.</summary>
public enum NativeArrayOptions
{
    UninitializedMemory = 0,
    ClearMemory = 1,
}
