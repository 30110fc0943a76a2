using System;
using System.Reflection;
using System.Reflection.Emit;

namespace Unity.Collections;

/// <summary>Offset of a field in its struct, asked of the runtime, because no managed call gives it for every struct.</summary>
internal static class FieldOffsets
{
    public static int Of(FieldInfo field)
    {
        var method = new DynamicMethod("OffsetOf", typeof(int), Type.EmptyTypes, typeof(FieldOffsets).Module, true);
        ILGenerator il = method.GetILGenerator();
        LocalBuilder instance = il.DeclareLocal(field.DeclaringType);
        il.Emit(OpCodes.Ldloca, instance);
        il.Emit(OpCodes.Ldflda, field);
        il.Emit(OpCodes.Conv_U);
        il.Emit(OpCodes.Ldloca, instance);
        il.Emit(OpCodes.Conv_U);
        il.Emit(OpCodes.Sub);
        il.Emit(OpCodes.Conv_I4);
        il.Emit(OpCodes.Ret);
        return ((Func<int>)method.CreateDelegate(typeof(Func<int>)))();
    }
}
