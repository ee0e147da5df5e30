using Engraver.TestKit;

namespace Engraver.Cli.Tests;

/// <summary>The drawings of the samples folder.</summary>
internal static class SampleDrawing
{
    public static IEnumerable<string> Names => Directory.GetFiles(RepositoryFolder.Samples, "*.dxf").Select(path => Path.GetFileNameWithoutExtension(path)).Order(StringComparer.Ordinal);

    /// <summary>A machine with a tool axis.</summary>
    public static string MillProfile => Path.Combine(RepositoryFolder.Samples, "machine-mill.json");

    public static string PathOf(string name) => Path.Combine(RepositoryFolder.Samples, name + ".dxf");
}
