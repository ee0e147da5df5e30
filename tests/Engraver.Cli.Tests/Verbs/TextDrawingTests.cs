using Engraver.TestKit;

namespace Engraver.Cli.Tests.Verbs;

/// <summary>Drawings that have texts and no curve.</summary>
public sealed class TextDrawingTests : IDisposable
{
    private static readonly (int Code, object Value)[] s_text = [(0, "TEXT"), (8, "0"), (10, 0.0), (20, 0.0), (40, 5.0), (1, "A")];

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public async Task The_plot_reports_what_is_wrong_with_its_letters()
    {
        var file = Written([.. s_text[..^1], (1, "A\\U+4E2D")]);

        var plot = await CliRun.RunAsync("plot", file, "--cut", "text", "-o", _folder.PathOf("a.svg"));

        Assert.Contains("TXT0005", plot.Error, StringComparison.Ordinal);
        Assert.True(File.Exists(_folder.PathOf("a.svg")));
    }

    [Fact]
    public async Task A_trajectory_of_a_field_is_refused_for_its_reason()
    {
        var file = Written([.. s_text[..^1], (1, "A[[n]]")]);

        var run = await CliRun.RunAsync("run", file, "--cut", "text", "--connect", "sim:", "--trajectory", "--journal", _folder.PathOf("a"));

        Assert.Contains("SER0002", run.Error, StringComparison.Ordinal);
        Assert.DoesNotContain("cannot be read", run.Error, StringComparison.Ordinal);
        Assert.NotEqual(0, run.ExitCode);
    }

    private string Written((int Code, object Value)[] entities)
    {
        var file = _folder.PathOf("text.dxf");
        File.WriteAllBytes(file, DxfText.WithEntities(entities).ToAscii());
        return file;
    }
}
