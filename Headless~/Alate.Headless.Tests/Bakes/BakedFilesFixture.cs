using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using NUnit.Framework;

namespace Alate.Tests.Bakes
{
    /// <summary>Tests of files that <c>bake</c> has written.</summary>
    public abstract class BakedFilesFixture
    {
        internal BakedFiles Files { get; } = new BakedFiles();

        /// <summary>All species but the one that the plain run bakes.</summary>
        protected static IEnumerable<string> Others => InsectCatalogue.Names.Except(["monarch"]);

        [OneTimeTearDown]
        public void RemoveFiles() => Files.Dispose();
    }
}
