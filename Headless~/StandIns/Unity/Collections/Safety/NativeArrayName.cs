namespace Unity.Collections;

/// <summary>Name of an array in messages: made once, as each array keeps it.</summary>
internal static class NativeArrayName<T>
{
    public static readonly string Value = $"NativeArray<{typeof(T).Name}>";
}
