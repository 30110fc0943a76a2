namespace Unity.Collections;

/// <summary>How messages call an array: made once, as each array keeps it.</summary>
internal static class NativeArrayName<T>
{
    public static readonly string Value = $"NativeArray<{typeof(T).Name}>";
}
