using NUnit.Framework;

namespace Alate.Tests.Play.Headless
{
    /// <summary>Tests of a crowd.</summary>
    public abstract class CrowdFixture : PlayFixture
    {
        internal CrowdScene Scene { get; set; }

        /// <inheritdoc/>
        protected override bool KeepsParts => true;

        [TearDown]
        public void ClearScene()
        {
            KeepParts();
            Scene?.Clear();
            Scene = null;
        }
    }
}
