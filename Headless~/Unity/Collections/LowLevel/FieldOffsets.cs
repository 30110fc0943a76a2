using System;
using System.Reflection;
using System.Reflection.Emit;

namespace Unity.Collections;

/// <summary>Where a field lies in its struct: asked of the runtime, as no managed call tells it for every struct.</summary>
internal static class FieldOffsets
{
    private const int k_AnyAddress = 4096;

    public static int Of(FieldInfo field)
    {
        var method = new DynamicMethod("OffsetOf", typeof(int), Type.EmptyTypes, typeof(FieldOffsets).Module, true);
        var il = method.GetILGenerator();
        il.Emit(OpCodes.Ldc_I4, k_AnyAddress);
        il.Emit(OpCodes.Conv_U);
        il.Emit(OpCodes.Ldflda, field);
        il.Emit(OpCodes.Conv_U);
        il.Emit(OpCodes.Ldc_I4, k_AnyAddress);
        il.Emit(OpCodes.Sub);
        il.Emit(OpCodes.Conv_I4);
        il.Emit(OpCodes.Ret);
        return ((Func<int>)method.CreateDelegate(typeof(Func<int>)))();
    }
}
