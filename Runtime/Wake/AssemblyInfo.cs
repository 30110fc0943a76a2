using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Alate.Tests")]
[assembly: InternalsVisibleTo("Alate.Headless.Tests")]
[assembly: InternalsVisibleTo("Alate.Cli")]
[assembly: InternalsVisibleTo("Alate.Benchmarks")]
