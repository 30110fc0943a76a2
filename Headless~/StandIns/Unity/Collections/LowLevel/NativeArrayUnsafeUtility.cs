namespace Unity.Collections.LowLevel.Unsafe;

public static unsafe class NativeArrayUnsafeUtility
{
    public static void* GetUnsafePtr<T>(this NativeArray<T> nativeArray) where T : struct
    {
        nativeArray.CheckWrite();
        return nativeArray.m_Buffer;
    }

    public static void* GetUnsafeReadOnlyPtr<T>(this NativeArray<T> nativeArray) where T : struct
    {
        nativeArray.CheckRead();
        return nativeArray.m_Buffer;
    }

    public static void* GetUnsafeReadOnlyPtr<T>(this NativeArray<T>.ReadOnly nativeArray) where T : struct
    {
        nativeArray.CheckRead();
        return nativeArray.m_Buffer;
    }

    public static void* GetUnsafeBufferPointerWithoutChecks<T>(NativeArray<T> nativeArray) where T : struct => nativeArray.m_Buffer;
}
