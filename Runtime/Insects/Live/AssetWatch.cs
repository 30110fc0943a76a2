using System.Collections.Generic;

namespace Alate
{
    /// <summary>
    /// Assets of one kind that are in use, each read once however many users it has. Assets that are no longer asked for are released, so
    /// that they can be unloaded.
    /// </summary>
    internal abstract class AssetWatch<TAsset, TValue> where TAsset : UnityEngine.Object where TValue : WatchedValue
    {
        private readonly Dictionary<TAsset, TValue> m_Values = new Dictionary<TAsset, TValue>();
        private readonly List<(TAsset asset, TValue value)> m_All = new List<(TAsset, TValue)>();
        private readonly TValue m_None;

        /// <param name="none">What stands for no asset.</param>
        protected AssetWatch(TValue none)
        {
            m_None = none;
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
                m_Values.Add(asset, value = Read(asset));
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

        /// <summary>Reads an asset for the first time.</summary>
        protected abstract TValue Read(TAsset asset);
    }
}
