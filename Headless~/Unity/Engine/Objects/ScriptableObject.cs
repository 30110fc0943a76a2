namespace UnityEngine;

public class ScriptableObject : Object
{
    public static T CreateInstance<T>() where T : ScriptableObject
    {
        var instance = (T)System.Activator.CreateInstance(typeof(T), nonPublic: true);
        return instance;
    }
}
