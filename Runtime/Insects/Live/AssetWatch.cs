using System;
using System.Collections.Generic;

namespace Alate
{
    /// <summary>
    /// The assets of one kind that are in use, each read once however many use it. Those that nobody asks for any more are let go, so that
    /// they can be unloaded.
    /// </summary>
    internal sealed class AssetWatch<TAsset, TValue> where TAsset : UnityEngine.Object where TValue : WatchedValue
    {
        private readonly Dictionary<TAsset, TValue> m_Values = new Dictionary<TAsset, TValue>();
        private readonly List<(TAsset asset, TValue value)> m_All = new List<(TAsset, TValue)>();
        private readonly Func<TAsset, TValue> m_Read;
        private readonly TValue m_None;

        /// <param name="read">Reads an asset for the first time; null stands for none.</param>
        public AssetWatch(Func<TAsset, TValue> read)
        {
            m_Read = read;
            m_None = read(null);
        }

        /// <summary>Assets that are watched now.</summary>
        public int Count => m_All.Count;

        /// <summary>Value read of an asset, or the default for none.</summary>
        public TValue Of(TAsset asset)
        {
            if (asset == null)
                return m_None;
            if (!m_Values.TryGetValue(asset, out TValue value))
            {
                m_Values.Add(asset, value = m_Read(asset));
                m_All.Add((asset, value));
            }

            return value;
        }

        /// <summary>Reads all assets again.</summary>
        public void Refresh()
        {
            foreach ((TAsset _, TValue value) in m_All)
                value.Refresh();
        }

        /// <summary>Ends a round: releases the assets that were not used for long.</summary>
        public void EndRound()
        {
            for (int k = m_All.Count - 1; k >= 0; k--)
            {
                (TAsset asset, TValue value) = m_All[k];
                if (value.EndRound())
                    continue;
                m_Values.Remove(asset);
                m_All.RemoveAt(k);
            }
        }
    }

    /// <summary>Values that are read from an asset, kept while it has users.</summary>
    internal abstract class WatchedValue
    {
        /// <summary>
        /// Frames without a look after which a value is let go: in slow motion steps are many frames apart, and insects may be disabled for
        /// a moment.
        /// </summary>
        private const int k_Patience = 600;

        private int m_FramesUnused;

        /// <summary>True where it was let go: then it is not read again, and has to be asked for again.</summary>
        public bool IsForgotten => m_FramesUnused > k_Patience;

        /// <summary>Reads the asset again. One that was destroyed keeps its last value.</summary>
        public abstract void Refresh();

        /// <returns>Whether somebody has looked lately.</returns>
        public bool EndRound()
        {
            m_FramesUnused++;
            return !IsForgotten;
        }

        /// <summary>Notes that the value is in use.</summary>
        protected void Use()
        {
            if (!IsForgotten)
                m_FramesUnused = 0;
        }
    }
}
