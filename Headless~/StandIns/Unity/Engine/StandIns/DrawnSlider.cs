using UnityEngine;

namespace StandIns;

/// <summary>Slider that was drawn on the screen, with the label above it and the values at its ends.</summary>
[Unity.StandIns.StandInExtension]
public sealed record DrawnSlider(string Label, Rect Place, float Value, float Left, float Right);
