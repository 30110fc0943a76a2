using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Events;

namespace Alate.Tests.Play
{
    /// <summary>
    /// Numbers, switches, choices and vectors that the engine serialises of a type, also in its groups and in the first entry of its lists:
    /// what an Animation window or a script can write beside all properties. A path is as "m_Steering.tilt" or "m_Wings[0].m_PhaseLead".
    /// </summary>
    public static class SerialisedNumbers
    {
        private const string k_First = "[0]";

        /// <summary>Components of the package that users can add, and so key.</summary>
        /// <param name="assemblies">Chooses assemblies by name.</param>
        public static IEnumerable<Type> Components(Func<string, bool> assemblies)
        {
            // Where assemblies are loaded when they are needed, some are not there yet.
            foreach (AssemblyName used in typeof(SerialisedNumbers).Assembly.GetReferencedAssemblies())
            {
                if (used.Name.StartsWith("Alate"))
                    Assembly.Load(used);
            }

            return AppDomain.CurrentDomain.GetAssemblies()
                .Where(assembly => assembly.GetName().Name.StartsWith("Alate") && assemblies(assembly.GetName().Name))
                .Where(assembly => assembly.GetReferencedAssemblies().All(used => used.Name != "nunit.framework"))
                .SelectMany(assembly => assembly.GetTypes())
                .Where(type => typeof(MonoBehaviour).IsAssignableFrom(type) && type.IsPublic && !type.IsAbstract)
                .OrderBy(type => type.Name);
        }

        /// <summary>Paths of all numbers.</summary>
        public static IEnumerable<string> Of(Type type)
        {
            foreach (FieldInfo field in Fields(type))
            {
                Type kind = field.FieldType, entry = EntryOf(kind);
                if (IsNumber(kind))
                {
                    yield return field.Name;
                }
                else if (entry != null && IsNumber(entry))
                {
                    yield return field.Name + k_First;
                }
                else if (IsGroup(entry ?? kind))
                {
                    foreach (string number in Of(entry ?? kind))
                        yield return $"{field.Name}{(entry == null ? "" : k_First)}.{number}";
                }
            }
        }

        /// <summary>Replaces a number.</summary>
        /// <param name="holder">A component or a group.</param>
        /// <param name="path">Of the number.</param>
        /// <param name="change">Gets the field and its value.</param>
        public static void Write(object holder, string path, Func<FieldInfo, object, object> change)
        {
            int end = path.IndexOf('.');
            string name = end < 0 ? path : path.Substring(0, end), rest = end < 0 ? "" : path.Substring(end + 1);
            FieldInfo field = Fields(holder.GetType()).First(one => one.Name == name.Replace(k_First, ""));
            IList list = name.EndsWith(k_First) ? (IList)field.GetValue(holder) : null;
            object value = list == null ? field.GetValue(holder) : list[0];
            if (rest.Length == 0)
                value = change(field, value);
            else
                Write(value, rest, change);
            if (list == null)
                field.SetValue(holder, value);
            else
                list[0] = value;
        }

        /// <summary>Another value within the range of a field.</summary>
        public static object Other(FieldInfo field, object value)
        {
            UnityEngine.RangeAttribute range = field.GetCustomAttribute<UnityEngine.RangeAttribute>();
            switch (value)
            {
                case bool flag: return !flag;
                case LayerMask layers: return (LayerMask)~layers.value;
                case Vector3 vector: return vector + new Vector3(0.4f, 0.3f, 0.5f);
                case uint number: return number + 41;
                case int number when range == null: return number + 41;
                case int number: return (int)math.lerp(range.min, range.max, number > 0.5f * (range.min + range.max) ? 0.25f : 0.75f);
                case float number when range == null: return 1.5f * number + 0.2f;
                case float number:
                    bool isHigh = number > 0.5f * (range.min + range.max);
                    return isHigh ? math.lerp(range.min, number, 0.5f) : math.lerp(number, range.max, 0.3f);
                case Enum _: return Enum.GetValues(field.FieldType).Cast<object>().First(other => !other.Equals(value));
                default: throw new NotSupportedException($"{field.Name} is a {value.GetType()}.");
            }
        }

        /// <summary>A value that no range holds; the value itself for switches and choices, which have none.</summary>
        /// <param name="value">The value now.</param>
        /// <param name="bad">Not a number, or much too large.</param>
        public static object Beyond(object value, float bad)
        {
            switch (value)
            {
                case float _: return bad;
                case Vector3 _: return new Vector3(bad, bad, bad);
                case int _ when !float.IsNaN(bad): return bad > 0f ? int.MaxValue : int.MinValue;
                default: return value;
            }
        }

        /// <summary>The end of a slider; <see cref="Beyond"/> for what is none.</summary>
        public static object AtEnd(FieldInfo field, object value, float bad)
        {
            UnityEngine.RangeAttribute range = field.GetCustomAttribute<UnityEngine.RangeAttribute>();
            float end = range == null ? 0f : bad > 0f ? range.max : range.min;
            return range == null ? Beyond(value, bad) : value is int ? (object)(int)end : end;
        }

        /// <summary>Returns true for a number with a range.</summary>
        public static bool IsSlider(Type type, string path)
        {
            foreach (string name in path.Replace(k_First, "").Split('.'))
            {
                FieldInfo field = Fields(type).First(one => one.Name == name);
                type = EntryOf(field.FieldType) ?? field.FieldType;
                if (field.GetCustomAttribute<UnityEngine.RangeAttribute>() != null)
                    return true;
            }

            return false;
        }

        private static bool IsNumber(Type kind) => kind.IsPrimitive || kind.IsEnum || kind == typeof(Vector2) || kind == typeof(Vector3)
            || kind == typeof(Vector4) || kind == typeof(Quaternion) || kind == typeof(Color) || kind == typeof(LayerMask);

        private static bool IsGroup(Type kind) => kind.GetCustomAttribute<SerializableAttribute>() != null && kind != typeof(string)
            && !typeof(UnityEventBase).IsAssignableFrom(kind) && !typeof(UnityEngine.Object).IsAssignableFrom(kind);

        private static Type EntryOf(Type kind) => kind.IsArray ? kind.GetElementType()
            : kind.IsGenericType && kind.GetGenericTypeDefinition() == typeof(List<>) ? kind.GetGenericArguments()[0] : null;

        private static IEnumerable<FieldInfo> Fields(Type type)
        {
            const BindingFlags own = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;
            for (; type != null && type != typeof(MonoBehaviour) && type != typeof(object); type = type.BaseType)
            {
                foreach (FieldInfo field in type.GetFields(own))
                {
                    bool isKept = field.IsPublic && field.GetCustomAttribute<NonSerializedAttribute>() == null
                        || field.GetCustomAttribute<SerializeField>() != null;
                    if (isKept && !field.IsInitOnly)
                        yield return field;
                }
            }
        }
    }
}
