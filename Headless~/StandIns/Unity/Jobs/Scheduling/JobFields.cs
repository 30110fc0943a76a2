using System;
using System.Collections.Generic;
using System.Reflection;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace Unity.Jobs;

/// <summary>The fields of a type of job that matter to the safety system, found once by reflection.</summary>
internal sealed class JobFields
{
    /// <summary>A NativeArray, or a view of one.</summary>
    public struct Container
    {
        public string name;
        public int offset;
        public bool isView;
        public bool readOnly;
        public bool writeOnly;
        public bool exempt;
    }

    private readonly string m_Job;
    private readonly List<Container> m_Containers = [];
    private readonly List<int> m_Restricted = [];
    private readonly List<int> m_ThreadIndices = [];

    public JobFields(Type job)
    {
        m_Job = job.Name;
        Visit(job, "", 0);
        Containers = [.. m_Containers];
        Restricted = [.. m_Restricted];
        ThreadIndices = [.. m_ThreadIndices];
    }

    public Container[] Containers { get; }

    /// <summary>Offsets of the arrays that an index of a parallel job may use at its own index only.</summary>
    public int[] Restricted { get; }

    /// <summary>Offsets of the fields with [NativeSetThreadIndex].</summary>
    public int[] ThreadIndices { get; }

    /// <summary>Reason why no job of this type can be scheduled; null if it can.</summary>
    public string Problem { get; private set; }

    private void Visit(Type type, string path, int offset)
    {
        foreach (FieldInfo field in type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic))
        {
            Type fieldType = field.FieldType;
            string name = path + field.Name;
            if (fieldType.IsPointer || fieldType.IsFunctionPointer)
            {
                if (!Has<NativeDisableUnsafePtrRestrictionAttribute>(field))
                    Problem ??= $"{m_Job}.{name} is a pointer. A job may have one only with [NativeDisableUnsafePtrRestriction].";
            }
            else if (!fieldType.IsValueType)
            {
                Problem ??= $"{m_Job}.{name} is a reference to a {fieldType.Name}. A job must hold values only.";
            }
            else if (fieldType.IsPrimitive || fieldType.IsEnum)
            {
                if (fieldType == typeof(int) && Has<NativeSetThreadIndexAttribute>(field))
                    m_ThreadIndices.Add(offset + UnsafeUtility.GetFieldOffset(field));
            }
            else if (IsContainer(fieldType, out bool isView))
            {
                AddContainer(field, name, offset + UnsafeUtility.GetFieldOffset(field), isView);
            }
            else if (!IsPlain(fieldType))
            {
                Visit(fieldType, name + ".", offset + UnsafeUtility.GetFieldOffset(field));
            }
        }
    }

    private void AddContainer(FieldInfo field, string name, int offset, bool isView)
    {
        var container = new Container
        {
            name = name,
            offset = offset,
            isView = isView,
            readOnly = isView || Has<ReadOnlyAttribute>(field),
            writeOnly = Has<WriteOnlyAttribute>(field),
            exempt = Has<NativeDisableContainerSafetyRestrictionAttribute>(field),
        };
        if (!container.readOnly && !container.exempt && !Has<NativeDisableParallelForRestrictionAttribute>(field))
            m_Restricted.Add(offset);
        m_Containers.Add(container);
    }

    private static bool Has<TAttribute>(FieldInfo field) where TAttribute : Attribute => field.IsDefined(typeof(TAttribute), false);

    private static bool IsContainer(Type type, out bool isView)
    {
        Type definition = type.IsGenericType ? type.GetGenericTypeDefinition() : null;
        isView = definition == typeof(NativeArray<>.ReadOnly);
        return isView || definition == typeof(NativeArray<>);
    }

    private static bool IsPlain(Type type) =>
        type.Namespace != null && (type.Namespace.StartsWith("System", StringComparison.Ordinal) || type.Namespace == "Unity.Mathematics");
}
