using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Alate.Catalogue")]
[assembly: InternalsVisibleTo("Alate.Crowds")]
[assembly: InternalsVisibleTo("Alate.Files")]
[assembly: InternalsVisibleTo("Alate.Editor")]
[assembly: InternalsVisibleTo("Alate.Proof")]
[assembly: InternalsVisibleTo("Alate.Wake")]
[assembly: InternalsVisibleTo("Alate.Tests")]
[assembly: InternalsVisibleTo("Alate.Editor.Tests")]
[assembly: InternalsVisibleTo("Alate.Headless.Tests")]
[assembly: InternalsVisibleTo("Alate.Cli")]
[assembly: InternalsVisibleTo("Alate.Benchmarks")]
