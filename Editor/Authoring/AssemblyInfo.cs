using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Alate.Files")]
[assembly: InternalsVisibleTo("Alate.Editor")]
[assembly: InternalsVisibleTo("Alate.Tests")]
[assembly: InternalsVisibleTo("Alate.Editor.Tests")]
[assembly: InternalsVisibleTo("Alate.Headless.Tests")]
[assembly: InternalsVisibleTo("Alate.Cli")]
[assembly: InternalsVisibleTo("Alate.Benchmarks")]
