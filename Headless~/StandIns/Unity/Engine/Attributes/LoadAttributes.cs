using System;
using UnityEngine.Scripting;

namespace UnityEngine
{
    public enum RuntimeInitializeLoadType
    {
        AfterSceneLoad = 0,
        BeforeSceneLoad = 1,
        AfterAssembliesLoaded = 2,
        BeforeSplashScreen = 3,
        SubsystemRegistration = 4,
    }

    [AttributeUsage(AttributeTargets.Method)]
    public class RuntimeInitializeOnLoadMethodAttribute(RuntimeInitializeLoadType loadType) : PreserveAttribute
    {
        public RuntimeInitializeOnLoadMethodAttribute() : this(RuntimeInitializeLoadType.AfterSceneLoad)
        {
        }

        public RuntimeInitializeLoadType loadType { get; } = loadType;
    }
}

namespace UnityEngine.Scripting
{
    [AttributeUsage((AttributeTargets)6141, Inherited = false)]
    public class PreserveAttribute : Attribute;
}
