using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Alate.Model")]
[assembly: InternalsVisibleTo("Alate.Fitting")]
[assembly: InternalsVisibleTo("Alate")]
[assembly: InternalsVisibleTo("Alate.Crowds")]
[assembly: InternalsVisibleTo("Alate.Catalogue")]
[assembly: InternalsVisibleTo("Alate.Authoring")]
[assembly: InternalsVisibleTo("Alate.Editor")]
[assembly: InternalsVisibleTo("Alate.Tests")]
[assembly: InternalsVisibleTo("Alate.Editor.Tests")]
[assembly: InternalsVisibleTo("Alate.Headless.Tests")]
[assembly: InternalsVisibleTo("Alate.Cli")]
[assembly: InternalsVisibleTo("Alate.Benchmarks")]
