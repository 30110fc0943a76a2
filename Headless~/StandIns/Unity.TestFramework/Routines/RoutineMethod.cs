using System;
using System.Collections;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;

namespace Unity.StandIns;

/// <summary>A method that returns a routine, shown to NUnit as one that returns nothing and runs the routine to its end.</summary>
internal sealed class RoutineMethod(IMethodInfo method) : IMethodInfo
{
    private static readonly ITypeInfo s_Void = new TypeWrapper(typeof(void));

    public ITypeInfo TypeInfo => method.TypeInfo;
    public System.Reflection.MethodInfo MethodInfo => method.MethodInfo;
    public string Name => method.Name;
    public bool IsAbstract => method.IsAbstract;
    public bool IsPublic => method.IsPublic;
    public bool IsStatic => method.IsStatic;
    public bool ContainsGenericParameters => method.ContainsGenericParameters;
    public bool IsGenericMethod => method.IsGenericMethod;
    public bool IsGenericMethodDefinition => method.IsGenericMethodDefinition;
    public ITypeInfo ReturnType => method.ReturnType.Type == typeof(IEnumerator) ? s_Void : method.ReturnType;

    public IParameterInfo[] GetParameters() => method.GetParameters();
    public Type[] GetGenericArguments() => method.GetGenericArguments();
    public IMethodInfo MakeGenericMethod(params Type[] typeArguments) => new RoutineMethod(method.MakeGenericMethod(typeArguments));
    public T[] GetCustomAttributes<T>(bool inherit) where T : class => method.GetCustomAttributes<T>(inherit);
    public bool IsDefined<T>(bool inherit) where T : class => method.IsDefined<T>(inherit);

    public object Invoke(object fixture, params object[] args)
    {
        RoutineRunner.Run((IEnumerator)method.Invoke(fixture, args));
        return null;
    }
}
