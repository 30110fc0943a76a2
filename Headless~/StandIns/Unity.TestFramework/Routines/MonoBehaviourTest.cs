namespace UnityEngine.TestTools;

/// <summary>A behaviour of its own object, waited for until it says that it has finished.</summary>
public class MonoBehaviourTest<T> : CustomYieldInstruction where T : MonoBehaviour, IMonoBehaviourTest
{
    public MonoBehaviourTest(bool dontDestroyOnLoad = true)
    {
        gameObject = new GameObject($"MonoBehaviourTest: {typeof(T).FullName}");
        component = gameObject.AddComponent<T>();
        if (dontDestroyOnLoad)
            Object.DontDestroyOnLoad(gameObject);
    }

    public T component { get; }

    public GameObject gameObject { get; }

    public override bool keepWaiting => !component.IsTestFinished;
}
