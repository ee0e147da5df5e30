using System.Text.Json.Nodes;
using Engraver.TestKit;

namespace Engraver.Cli.Tests.Samples;

/// <summary>The script of the finished plate: three tools, a text in an outline font, a serial number, stops at each change of the tool, a series.</summary>
public class SampleScriptTests
{
    [Fact]
    public async Task The_script_finishes_a_plate_with_three_tools_and_counts_the_plates()
    {
        if (!OperatingSystem.IsLinux()) return; // the folder of the counters is given by variables of Linux
        using var folder = new TemporaryFolder();
        var (programs, result) = (Directory.CreateDirectory(folder.PathOf("programs")).FullName, folder.PathOf("result"));
        using var script = EngraverProcess.StartScript(programs, Path.Combine(RepositoryFolder.Samples, "finished-plate.sh"), result, "1");
        script.In.Close();
        var (output, errors) = (script.Out.ReadToEndAsync(), script.Error.ReadToEndAsync());
        await script.WaitAsync(CancellationToken.None);

        Assert.True(script.ExitCode == 0, await output + await errors);
        Assert.Equal(2, (await output).Split("the whole drawing was cut").Length - 1);
        Assert.Equal(["toolChange", "toolChange", "complete"], Enumerable.Range(1, 3).Select(section => File.ReadLines(Path.Combine(result, $"section-{section}.jsonl")).Select(line => (string?)JsonNode.Parse(line)!["outcome"]).Last(outcome => outcome is not null)));
        Assert.Equal(["n=1", "n=2"], Directory.GetFiles(Path.Combine(result, "CncEngraver", "history"), "*.json").Order(StringComparer.Ordinal).Select(file => (string?)JsonNode.Parse(File.ReadAllText(file))!["plate"]).Distinct());
    }
}
