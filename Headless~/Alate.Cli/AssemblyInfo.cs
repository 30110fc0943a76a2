using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Alate.Headless.Tests")]
