using System;
using System.Collections.Generic;

namespace StandIns;

/// <summary>The progress bar of the editor.</summary>
[Unity.StandIns.StandInExtension]
public static class ShownProgress
{
    /// <summary>Texts and shares since the last <see cref="Begin"/>.</summary>
    public static List<(string Info, float Share)> Shown { get; } = [];

    /// <summary>True while the bar is there.</summary>
    public static bool IsOpen { get; private set; }

    /// <summary>Number of showings after which the user presses Cancel.</summary>
    public static int CancelAfter { get; set; } = int.MaxValue;

    /// <summary>Forgets what was shown; nobody cancels.</summary>
    public static void Begin()
    {
        Shown.Clear();
        CancelAfter = int.MaxValue;
    }

    internal static bool Show(string info, float share)
    {
        if (!(share >= 0f && share <= 1f))
            throw new ArgumentOutOfRangeException(nameof(share), share, "A bar shows 0 to 1.");
        IsOpen = true;
        Shown.Add((info, share));
        return Shown.Count > CancelAfter;
    }

    internal static void Clear() => IsOpen = false;
}
