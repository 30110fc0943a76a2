using System;

namespace UnityEngine;

/// <summary>End of any call that draws a user interface: there is none to draw on.</summary>
internal static class Absent
{
    public static Exception Gui => new NotSupportedException("There is no user interface in the headless build.");
}
