using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Reflection.Emit;

namespace Alate.Tests.Architecture
{
    /// <summary>The types that a type uses: in its declaration, its members, and the code of its methods.</summary>
    internal static class TypeUses
    {
        private const BindingFlags k_Own =
            BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Static | BindingFlags.Instance | BindingFlags.DeclaredOnly;

        private static readonly Dictionary<short, OpCode> s_OpCodes = typeof(OpCodes).GetFields()
            .Select(field => (OpCode)field.GetValue(null)).ToDictionary(code => code.Value);

        private static readonly Dictionary<Type, Type[]> s_Known = new Dictionary<Type, Type[]>();

        /// <summary>Top-level types that a top-level type and its nested types use, itself left out.</summary>
        public static IReadOnlyList<Type> Of(Type type)
        {
            if (!s_Known.TryGetValue(type, out Type[] known))
            {
                s_Known.Add(type, known = WithNested(type).SelectMany(OfOne).SelectMany(Parts).Select(TopLevel).Where(used => used != type)
                    .Distinct().ToArray());
            }
            return known;
        }

        /// <summary>The type that a nested one stands in.</summary>
        public static Type TopLevel(Type type)
        {
            while (type.DeclaringType != null)
                type = type.DeclaringType;
            return type.IsGenericType && !type.IsGenericTypeDefinition ? type.GetGenericTypeDefinition() : type;
        }

        private static IEnumerable<Type> WithNested(Type type) =>
            type.GetNestedTypes(BindingFlags.Public | BindingFlags.NonPublic).SelectMany(WithNested).Prepend(type);

        private static IEnumerable<Type> OfOne(Type type)
        {
            var used = new List<Type> { type.BaseType };
            used.AddRange(type.GetInterfaces());
            used.AddRange(type.GetCustomAttributesData().Select(attribute => attribute.AttributeType));
            foreach (FieldInfo field in type.GetFields(k_Own))
                used.Add(field.FieldType);
            foreach (MethodBase method in type.GetMethods(k_Own).Cast<MethodBase>().Concat(type.GetConstructors(k_Own)))
            {
                used.AddRange(method.GetParameters().Select(parameter => parameter.ParameterType));
                used.Add((method as MethodInfo)?.ReturnType);
                MethodBody body = method.GetMethodBody();
                if (body == null)
                    continue;
                used.AddRange(body.LocalVariables.Select(local => local.LocalType));
                used.AddRange(InCode(method, body.GetILAsByteArray()));
            }

            return used.Where(one => one != null);
        }

        private static IEnumerable<Type> InCode(MethodBase method, byte[] code)
        {
            Type[] ofType = method.DeclaringType.IsGenericType ? method.DeclaringType.GetGenericArguments() : null;
            Type[] ofMethod = method.IsGenericMethod ? method.GetGenericArguments() : null;
            for (int at = 0; at < code.Length;)
            {
                short value = code[at++];
                if (value == 0xFE)
                    value = (short)(0xFE00 | code[at++]);
                OpCode op = s_OpCodes[value];
                if (op.OperandType is OperandType.InlineType or OperandType.InlineMethod or OperandType.InlineField
                    or OperandType.InlineTok)
                {
                    MemberInfo member = method.Module.ResolveMember(BitConverter.ToInt32(code, at), ofType, ofMethod);
                    yield return member as Type ?? member.DeclaringType;
                    if (member is MethodInfo { IsGenericMethod: true } generic)
                    {
                        foreach (Type argument in generic.GetGenericArguments())
                            yield return argument;
                    }
                }

                at += Size(op.OperandType, code, at);
            }
        }

        private static int Size(OperandType operand, byte[] code, int at) => operand switch
        {
            OperandType.InlineNone => 0,
            OperandType.ShortInlineBrTarget or OperandType.ShortInlineI or OperandType.ShortInlineVar => 1,
            OperandType.InlineVar => 2,
            OperandType.InlineI8 or OperandType.InlineR => 8,
            OperandType.InlineSwitch => 4 + 4 * BitConverter.ToInt32(code, at),
            _ => 4,
        };

        private static IEnumerable<Type> Parts(Type type)
        {
            while (type.HasElementType)
                type = type.GetElementType();
            if (type.IsGenericParameter)
                return [];
            return type.IsGenericType ? type.GetGenericArguments().SelectMany(Parts).Append(type) : [type];
        }
    }
}
