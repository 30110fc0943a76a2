using UnityEngine;

namespace StandIns;

/// <summary>One control of an inspector that was drawn.</summary>
[Unity.StandIns.StandInExtension]
public sealed record DrawnControl(ControlKind Kind, Rect Place, string Text, string Tooltip, string Value, bool Enabled);
