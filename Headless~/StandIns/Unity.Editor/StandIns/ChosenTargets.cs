using System.Collections.Generic;
using UnityEngine;

namespace StandIns;

/// <summary>Objects that the tools of the scene view work on.</summary>
[Unity.StandIns.StandInExtension]
public static class ChosenTargets
{
    public static List<Object> All { get; } = [];
}
