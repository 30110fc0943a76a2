using UnityEngine;

namespace Unity.StandIns;

/// <summary>One control of an inspector that was drawn.</summary>
[StandInExtension]
public sealed record DrawnControl(ControlKind Kind, Rect Place, string Text, string Tooltip, string Value, bool Enabled);
