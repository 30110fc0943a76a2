using System;
using System.Collections;
using System.Collections.Generic;
using System.Diagnostics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace Unity.Collections;

public unsafe partial struct NativeArray<T>
{
    /// <summary>View of the memory without the means to write it.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct ReadOnly : IEnumerable<T>
    {
        internal void* m_Buffer;
        internal int m_Length;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        internal SafetyHandle m_Safety;
#endif

        internal ReadOnly(in NativeArray<T> array)
        {
            m_Buffer = array.m_Buffer;
            m_Length = array.m_Length;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            m_Safety = array.m_Safety;
#endif
        }

        public readonly int Length
        {
            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            get => m_Length;
        }

        public readonly bool IsCreated => m_Buffer != null;

        public readonly T this[int index]
        {
            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            get
            {
                CheckReadAt(index);
                return Unsafe.Add(ref Unsafe.AsRef<T>(m_Buffer), index);
            }
        }

        public readonly T[] ToArray()
        {
            var array = new T[m_Length];
            Copy(this, array, m_Length);
            return array;
        }

        public readonly void CopyTo(T[] array) => Copy(this, array);

        public readonly void CopyTo(NativeArray<T> array) => Copy(this, array);

        public readonly ReadOnlySpan<T> AsReadOnlySpan()
        {
            CheckRead();
            return new ReadOnlySpan<T>(m_Buffer, m_Length);
        }

        public static implicit operator ReadOnlySpan<T>(in ReadOnly source) => source.AsReadOnlySpan();

        public readonly NativeArray<U>.ReadOnly Reinterpret<U>() where U : struct
        {
            if (Unsafe.SizeOf<T>() != Unsafe.SizeOf<U>())
            {
                throw new InvalidOperationException(
                    $"Types {typeof(T)} and {typeof(U)} are different sizes - direct reinterpretation is not possible.");
            }
            ReadOnly view = this;
            return Unsafe.As<ReadOnly, NativeArray<U>.ReadOnly>(ref view);
        }

        public readonly Enumerator GetEnumerator() => new(in this);

        readonly IEnumerator<T> IEnumerable<T>.GetEnumerator() => GetEnumerator();

        readonly IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

        [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        internal readonly void CheckRead()
        {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            if (m_Safety.cell != null && m_Safety.RefusesRead)
                throw SafetyErrors.Of(m_Safety, Name, false);
#endif
        }

        [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private readonly void CheckReadAt(int index)
        {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            if ((uint)index >= (uint)m_Length || m_Safety.RefusesRead)
                ThrowAt(index, m_Length, m_Safety);
#endif
        }

#if ENABLE_UNITY_COLLECTIONS_CHECKS
        private static void ThrowAt(int index, int length, SafetyHandle safety) => throw ErrorAt(index, length, 0, length, safety, false);
#endif

        public struct Enumerator : IEnumerator<T>
        {
            private ReadOnly m_Array;
            private int m_Index;

            public Enumerator(in ReadOnly array)
            {
                m_Array = array;
                m_Index = -1;
            }

            public readonly T Current => m_Array[m_Index];

            readonly object IEnumerator.Current => Current;

            public bool MoveNext() => ++m_Index < m_Array.m_Length;

            public void Reset() => m_Index = -1;

            public readonly void Dispose()
            {
            }
        }
    }

    public struct Enumerator : IEnumerator<T>
    {
        private NativeArray<T> m_Array;
        private int m_Index;

        public Enumerator(ref NativeArray<T> array)
        {
            m_Array = array;
            m_Index = -1;
        }

        public readonly T Current => m_Array[m_Index];

        readonly object IEnumerator.Current => Current;

        public bool MoveNext() => ++m_Index < m_Array.m_Length;

        public void Reset() => m_Index = -1;

        public readonly void Dispose()
        {
        }
    }
}
