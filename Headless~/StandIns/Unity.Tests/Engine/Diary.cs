using System.Collections.Generic;
using UnityEngine;

namespace Unity.Tests.Engine;

/// <summary>Writes down each message that it hears.</summary>
public class Diary : MonoBehaviour
{
    public static readonly List<string> Lines = new();

    private void Awake() => Write(nameof(Awake));
    private void OnEnable() => Write(nameof(OnEnable));
    private void Start() => Write(nameof(Start));
    private void FixedUpdate() => Write(nameof(FixedUpdate));
    private void Update() => Write(nameof(Update));
    private void LateUpdate() => Write(nameof(LateUpdate));

    private void OnDisable()
    {
        Write(nameof(OnDisable));
        Disabled();
    }

    private void OnDestroy() => Write(nameof(OnDestroy));

    protected virtual void Disabled()
    {
    }

    private void Write(string message) => Lines.Add($"{name}.{message}");
}

[DefaultExecutionOrder(-10)]
public sealed class EarlyDiary : Diary
{
}
