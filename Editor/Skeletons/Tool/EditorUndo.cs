using System.Collections.Generic;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Records commands in the editor's own undo history, one group a step.</summary>
    internal sealed class EditorUndo : IUndoRecorder
    {
        private readonly HashSet<Object> m_Recorded = new HashSet<Object>();
        private string m_UndoName;
        private int m_Group;
        private int m_Depth;

        public void Begin(string undoName)
        {
            if (m_Depth++ > 0)
                return;
            m_UndoName = undoName;
            m_Recorded.Clear();
            Undo.IncrementCurrentGroup();
            m_Group = Undo.GetCurrentGroup();
        }

        // Complete, not by differences: commands replace whole arrays within arrays.
        public void Record(Object target)
        {
            if (m_Recorded.Add(target))
                Undo.RegisterCompleteObjectUndo(target, m_UndoName);
        }

        public void Changed(Object target) => EditorUtility.SetDirty(target);

        public void End()
        {
            if (m_Depth == 0 || --m_Depth > 0 || m_Recorded.Count == 0)
                return;
            Undo.SetCurrentGroupName(m_UndoName);
            Undo.CollapseUndoOperations(m_Group);
        }

        public void Cancel()
        {
            if (m_Depth == 0)
                return;
            m_Depth = 0;
            if (m_Recorded.Count > 0)
                Undo.RevertAllDownToGroup(m_Group);
        }
    }
}
