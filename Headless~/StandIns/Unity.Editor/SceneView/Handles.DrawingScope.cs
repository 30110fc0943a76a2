using System;
using UnityEngine;

namespace UnityEditor;

public partial class Handles
{
    public struct DrawingScope : IDisposable
    {
        public DrawingScope(Color color) : this(color, Handles.matrix)
        {
        }

        public DrawingScope(Matrix4x4 matrix) : this(Handles.color, matrix)
        {
        }

        public DrawingScope(Color color, Matrix4x4 matrix)
        {
            originalColor = Handles.color;
            originalMatrix = Handles.matrix;
            Handles.color = color;
            Handles.matrix = matrix;
        }

        public Color originalColor { get; }

        public Matrix4x4 originalMatrix { get; }

        public void Dispose()
        {
            Handles.color = originalColor;
            Handles.matrix = originalMatrix;
        }
    }
}
