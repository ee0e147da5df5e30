using System.Globalization;
using System.Text.Json;
using System.Xml;
using System.Xml.Linq;
using Engraver.TestKit;

namespace Engraver.Cli.Tests.Verbs;

/// <summary>The job report is well-formed and self-contained, has the exact figures of <c>plan</c>, and does not execute content of the drawing.</summary>
public class ReportVerbTests
{
    private const string Html = "{http://www.w3.org/1999/xhtml}";

    [Fact]
    public async Task Its_figures_are_those_of_plan()
    {
        using var folder = new TemporaryFolder();
        string[] words = [folder.WithFile("report-plan.dxf", await File.ReadAllTextAsync(SampleDrawing.PathOf("gasket"))), "--rate", "60,2.5,0.75", "--feed", "500"];
        var run = await CliRun.RunAsync(["report", .. words, "-o", folder.PathOf("a.html")]);
        var plan = JsonText.Of(await CliRun.RunAsync(["plan", .. words, "--json"]));
        var page = Read(folder.PathOf("a.html"));
        var sheet = Section(page, "sheet");

        Assert.Equal((ExitCode.Done, ""), (run.ExitCode, run.Error));
        foreach (var name in new[] { "seconds.total", "seconds.cutting", "seconds.rapid", "seconds.dwell", "cutLength", "travel", "peakSpeed", "peakAxisAcceleration", "cost", "costParts.time", "costParts.length", "costParts.starts" })
            Assert.Equal(name.Split('.').Aggregate(plan, (at, part) => at.GetProperty(part)).GetDouble(), Figure(sheet, name));
        Assert.Equal(["path", "speed", "sheet", "certificate", "findings", "settings"], page.Descendants(Html + "section").Select(section => section.Attribute("id")!.Value));
        Assert.Equal(2, page.Descendants("{http://www.w3.org/2000/svg}svg").Count());
    }

    [Fact]
    public async Task Every_operation_and_tool_has_a_line_with_its_cost()
    {
        using var folder = new TemporaryFolder();
        string[] words = [folder.WithFile("report-operations.dxf", await File.ReadAllTextAsync(SampleDrawing.PathOf("operation-plate"))), "--operations", Path.Combine(RepositoryFolder.Samples, "operation-plate.operations.json"), "--machine", Path.Combine(RepositoryFolder.Samples, "machine-mill.json"), "--rate", "60,2.5,0.75"];
        await CliRun.RunAsync(["report", .. words, "-o", folder.PathOf("a.html")]);
        var plan = JsonText.Of(await CliRun.RunAsync(["plan", .. words, "--json"]));
        var sheet = Section(Read(folder.PathOf("a.html")), "sheet");

        Assert.All(plan.GetProperty("operations").EnumerateArray(), one => Assert.Equal(Cost(one.GetProperty("planned")), Figure(sheet, $"operations.{one.GetProperty("id").GetString()}.planned.cost")));
        Assert.All(plan.GetProperty("tools").EnumerateArray(), one => Assert.Equal(Cost(one.GetProperty("planned")), Figure(sheet, $"tools.{one.GetProperty("tool")}.planned.cost")));
        Assert.Equal(Cost(plan.GetProperty("around")), Figure(sheet, "around.cost"));
        Assert.Contains("strokes 8, length ", Cell(sheet, "operations.outline.planned.cost").Value, StringComparison.Ordinal);

        static double Cost(JsonElement part) => part.GetProperty("cost").GetDouble();
    }

    [Fact]
    public async Task After_a_run_it_has_the_outcome_the_deviation_the_list_and_the_certificate()
    {
        using var folder = new TemporaryFolder();
        var drawing = folder.WithFile("report-run.dxf", await File.ReadAllTextAsync(SampleDrawing.PathOf("paper-001")));
        await CliRun.RunAsync("certify", drawing);
        var run = JsonText.Of(await CliRun.RunAsync("run", drawing, "--connect", "sim:", "--json", "--journal", folder.PathOf("a.jsonl")));
        await CliRun.RunAsync("report", drawing, "-o", folder.PathOf("a.html"), "--journal", folder.PathOf("a.jsonl"));
        await CliRun.RunAsync("report", drawing, "-o", folder.PathOf("b.html"));
        var page = Read(folder.PathOf("a.html"));
        using var certificate = JsonDocument.Parse(await File.ReadAllTextAsync(folder.PathOf("report-run.certificate.json")));

        Assert.Equal(["path", "speed", "deviation", "sheet", "run", "checks", "certificate", "findings", "settings"], page.Descendants(Html + "section").Select(section => section.Attribute("id")!.Value));
        Assert.Equal(run.GetProperty("maxDeviation").GetDouble(), Figure(Section(page, "run"), "maxDeviation"));
        Assert.Equal(run.GetProperty("seconds").GetDouble(), Figure(Section(page, "run"), "seconds"));
        Assert.Equal(run.GetProperty("checks").EnumerateArray().Select(check => check.GetProperty("sentence").GetString()), Section(page, "checks").Descendants(Html + "tbody").Single().Elements().Select(row => row.Elements().Last().Value));
        Assert.Equal("valid", Cell(Section(page, "certificate"), "standing").Value);
        Assert.Equal(certificate.RootElement.GetProperty("program").GetProperty("sha256").GetString(), Cell(Section(page, "certificate"), "program.sha256").Value);
        Assert.Equal(Body(await File.ReadAllTextAsync(folder.PathOf("a.html"))), Body(await File.ReadAllTextAsync(folder.PathOf("b.html"))));
        var entry = JsonText.Of(await CliRun.RunAsync("history", "--json", "--search", drawing)).GetProperty("entries").EnumerateArray().First(one => one.GetProperty("kind").GetString() == "run");
        Assert.Equal(folder.PathOf("b.html"), entry.GetProperty("report").GetString());
    }

    /// <summary>Figures of a run of another state of the job are not shown as those of the reported job.</summary>
    [Fact]
    public async Task A_run_before_the_drawing_or_a_setting_changed_is_told_as_such()
    {
        using var folder = new TemporaryFolder();
        var drawing = folder.WithFile("report-changed.dxf", await File.ReadAllTextAsync(SampleDrawing.PathOf("paper-001")));
        await CliRun.RunAsync("run", drawing, "--connect", "sim:", "--journal", folder.PathOf("a.jsonl"));
        await CliRun.RunAsync("report", drawing, "-o", folder.PathOf("same.html"));
        await CliRun.RunAsync("report", drawing, "-o", folder.PathOf("setting.html"), "--max-error", "0.005", "--feed", "300");
        await File.AppendAllTextAsync(drawing, "\n");
        await CliRun.RunAsync("report", drawing, "-o", folder.PathOf("drawing.html"));

        Assert.Equal("Run: complete", Verdict("same"));
        Assert.DoesNotContain("This run was made with a different version of the job", Section(Read(folder.PathOf("same.html")), "run").Value, StringComparison.Ordinal);
        Assert.Equal("Run of a different version of this job: complete", Verdict("setting"));
        Assert.Contains("This run was made with a different version of the job. Changed since then: --max-error, the machine profile.", Section(Read(folder.PathOf("setting.html")), "run").Value, StringComparison.Ordinal);
        Assert.Equal("Run of a different version of this job: complete", Verdict("drawing"));
        Assert.Contains("This run was made with a different version of the job. Changed since then: the drawing.", Section(Read(folder.PathOf("drawing.html")), "run").Value, StringComparison.Ordinal);

        string Verdict(string name) => Read(folder.PathOf(name + ".html")).Descendants(Html + "p").Single(part => part.Attribute("class")?.Value == "verdict").Value;
    }

    [Fact]
    public async Task A_run_of_trajectories_is_told_as_such_and_keeps_the_settings_of_the_document()
    {
        using var folder = new TemporaryFolder();
        var drawing = folder.WithFile("report-followed.dxf", await File.ReadAllTextAsync(SampleDrawing.PathOf("paper-001")));
        await CliRun.RunAsync("run", drawing, "--connect", "sim:", "--trajectory", "--max-error", "0.002", "--journal", folder.PathOf("a.jsonl"));
        await CliRun.RunAsync("report", drawing, "-o", folder.PathOf("a.html"), "--max-error", "0.002");
        var settings = JsonText.Of(await CliRun.RunAsync("history", "--json", "--search", drawing)).GetProperty("entries")[0].GetProperty("settings");

        Assert.Equal(("0.002", "nearest"), (settings.GetProperty("max-error").GetString(), settings.GetProperty("order").GetString()));
        Assert.Contains("followed the trajectories", Section(Read(folder.PathOf("a.html")), "run").Value, StringComparison.Ordinal);
    }

    /// <summary>Names of layers and files are untrusted: shown but not executed.</summary>
    [Theory]
    [InlineData("<script>alert(1)</script>", true)]
    [InlineData("</style><img src=x onerror=alert(1)>", true)]
    [InlineData("\"'><svg/onload=alert(1)>&amp;&#x3C;", true)]
    [InlineData("]]><!-- &nbsp; \u0007\u202E\uFFFE", false)]
    public async Task What_a_drawing_says_is_shown_and_not_obeyed(string layer, bool isWhole)
    {
        using var folder = new TemporaryFolder();
        var drawing = folder.PathOf("a<b>&'\".dxf");
        await File.WriteAllBytesAsync(drawing, DxfText.WithEntities((0, "LINE"), (8, layer), (10, 0.0), (20, 0.0), (11, 5.0), (21, 0.0), (0, "TEXT"), (8, layer), (10, 0.0), (20, 0.0), (40, 1.0), (1, layer)).ToAscii());
        string[] words = ["report", drawing, "-o", folder.PathOf("a.html")];
        var named = await CliRun.RunAsync([.. words, "--layers", layer]);
        var run = isWhole ? named : await CliRun.RunAsync(words);
        var text = await File.ReadAllTextAsync(folder.PathOf("a.html"));
        var page = Read(folder.PathOf("a.html"));

        Assert.NotEqual(ExitCode.Usage, run.ExitCode);
        Assert.DoesNotContain(page.Descendants(), element => element.Name.LocalName is "script" or "img" or "iframe" or "object" or "link" or "a" or "foreignObject");
        Assert.DoesNotContain(page.Descendants().Attributes(), attribute => attribute.Name.LocalName.StartsWith("on", StringComparison.OrdinalIgnoreCase) || attribute.Name.LocalName is "href" or "src");
        Assert.DoesNotContain("alert(1)<", text, StringComparison.Ordinal);
        Assert.DoesNotContain("url(", text, StringComparison.Ordinal);
        if (isWhole) Assert.Equal(layer, JsonSerializer.Deserialize<string[]>(Cell(Section(page, "settings"), "settings.layers").Value)!.Single());
        Assert.Equal("a<b>&'\".dxf", page.Descendants(Html + "title").Single().Value);
        Assert.Contains("default-src 'none'", text, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_trace_of_another_drawing_a_journal_that_is_not_there_and_nothing_to_cut_are_told()
    {
        using var folder = new TemporaryFolder();
        var drawing = folder.WithFile("report-other.dxf", await File.ReadAllTextAsync(SampleDrawing.PathOf("paper-001")));
        await CliRun.RunAsync("run", drawing, "--connect", "sim:", "--journal", folder.PathOf("a.jsonl"));
        var other = await CliRun.RunAsync("report", SampleDrawing.PathOf("gasket"), "--journal", folder.PathOf("a.jsonl"), "-o", folder.PathOf("a.html"));
        var gone = await CliRun.RunAsync("report", drawing, "--journal", folder.PathOf("nowhere"), "-o", folder.PathOf("b.html"));
        await File.WriteAllBytesAsync(folder.PathOf("empty.dxf"), DxfText.WithEntities().ToAscii());
        await CliRun.RunAsync("report", folder.PathOf("empty.dxf"), "-o", folder.PathOf("c.html"));
        var unreadable = await CliRun.RunAsync("report", folder.PathOf("nowhere.dxf"), "-o", folder.PathOf("d.html"));

        Assert.Equal((ExitCode.Done, ExitCode.Usage, ExitCode.DrawingError), (other.ExitCode, gone.ExitCode, unreadable.ExitCode));
        Assert.StartsWith("engraver: the page does not show the recorded path of the machine: ", other.Error, StringComparison.Ordinal);
        Assert.Empty(Section(Read(folder.PathOf("a.html")), "deviation").Descendants("{http://www.w3.org/2000/svg}svg"));
        Assert.Contains("Nothing in this drawing can be cut", Read(folder.PathOf("c.html")).Root!.Value, StringComparison.Ordinal);
        Assert.All(["b.html", "d.html"], name => Assert.False(File.Exists(folder.PathOf(name))));
    }

    /// <summary>Parsed as XML, without the tolerance of HTML.</summary>
    private static XDocument Read(string path)
    {
        using var reader = XmlReader.Create(path, new XmlReaderSettings { DtdProcessing = DtdProcessing.Ignore, XmlResolver = null, CheckCharacters = true });
        return XDocument.Load(reader);
    }

    private static XElement Section(XDocument page, string id) => page.Descendants(Html + "section").Single(section => section.Attribute("id")!.Value == id);

    private static XElement Cell(XElement section, string name) => section.Descendants(Html + "td").Single(cell => cell.Attribute("data-name")?.Value == name);

    private static double Figure(XElement section, string name) => double.Parse(Cell(section, name).Attribute("data-value")!.Value, NumberStyles.Float, CultureInfo.InvariantCulture);

    /// <summary>Without the date of the report.</summary>
    private static string Body(string text) => string.Concat(text.Split('\n').Where(line => !line.Contains("Job report, created", StringComparison.Ordinal)));

    /// <summary>Regression: such a page stated that the job had not been run.</summary>
    [Fact]
    public async Task A_run_that_the_history_does_not_know_is_told_by_its_journal()
    {
        using var folder = new TemporaryFolder();
        var drawing = SampleDrawing.PathOf("paper-001");
        await CliRun.RunAsync("run", drawing, "--connect", "sim:", "--journal", folder.PathOf("known.jsonl"));
        File.Copy(folder.PathOf("known.jsonl"), folder.PathOf("foreign.jsonl"));
        var report = await CliRun.RunAsync("report", drawing, "--journal", folder.PathOf("foreign.jsonl"), "-o", folder.PathOf("page.html"));
        var page = File.ReadAllText(folder.PathOf("page.html"));

        Assert.Equal(ExitCode.Done, report.ExitCode);
        Assert.Contains("Run: complete", page, StringComparison.Ordinal);
        Assert.Contains("comes from its journal only", page, StringComparison.Ordinal);
    }
}
