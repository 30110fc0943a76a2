namespace Unity.Collections;

/// <summary>Clearing of new memory.</summary>
public enum NativeArrayOptions
{
    UninitializedMemory = 0,
    ClearMemory = 1,
}
