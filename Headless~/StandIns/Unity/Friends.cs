using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Unity.Editor")]
