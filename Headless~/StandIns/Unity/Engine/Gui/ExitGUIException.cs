using System;

namespace UnityEngine;

/// <summary>Ends the drawing of a window at once; what draws it takes that for a normal end.</summary>
public sealed class ExitGUIException : Exception;
