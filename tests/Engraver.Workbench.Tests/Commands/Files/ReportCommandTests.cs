using System.Xml.Linq;
using Engraver.Workbench.Commands;

namespace Engraver.Workbench.Tests.Commands.Files;

public class ReportCommandTests
{
    [Fact]
    public async Task The_page_stands_beside_the_drawing_with_the_last_run_and_the_history_knows_it()
    {
        await using var talk = new CommandTestSession();
        File.Copy(CommandTestSession.Sample("paper-001.dxf"), talk.PathOf("part.dxf"));
        await talk.TypeAsync("OPEN", "part.dxf");
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("REPORT", ""));
        Assert.Equal(["path", "speed", "sheet", "certificate", "findings", "settings"], Sections(talk.PathOf("part.report.html")));

        await talk.TypeAsync("CNCSIM");
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("REPORT", "other.html"));
        Assert.Equal(["path", "speed", "deviation", "sheet", "run", "checks", "certificate", "findings", "settings"], Sections(talk.PathOf("other.html")));
        Assert.Equal(talk.PathOf("other.html"), Assert.Single(talk.Session.History.Refresh().Entries).Report);
    }

    /// <summary>Uses the settings of the job, not the current ones.</summary>
    [Fact]
    public async Task The_page_of_a_job_in_the_history_is_of_its_own_settings()
    {
        await using var talk = new CommandTestSession();
        File.Copy(CommandTestSession.Sample("paper-001.dxf"), talk.PathOf("part.dxf"));
        await talk.TypeAsync("OPEN", "part.dxf", "CNCMAXERR", "0.004", "CNCSIM", "CNCMAXERR", "0.001");
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("HISTORY", "rePort", "1"));
        var page = XDocument.Load(talk.PathOf("part.report.html"));

        Assert.Equal("0.004", page.Descendants().Single(cell => cell.Attribute("data-name")?.Value == "settings.max-error").Value);
        Assert.Contains("deviation", Sections(talk.PathOf("part.report.html")));
        File.Delete(talk.PathOf("part.dxf"));
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("HISTORY", "rePort", "1"));
    }

    private static IEnumerable<string> Sections(string page) => XDocument.Load(page).Descendants("{http://www.w3.org/1999/xhtml}section").Select(section => section.Attribute("id")!.Value);
}
