using System;

namespace UnityEngine;

/// <summary>What drawing a user interface ends in: there is none to draw on.</summary>
internal static class Absent
{
    public static Exception Gui => new NotSupportedException("There is no user interface in the headless build.");
}
