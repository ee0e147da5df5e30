using Engraver.TestKit;

namespace Engraver.Cli.Tests.Verbs;

/// <summary>Bad input: an exit code, one clear sentence, no stack trace.</summary>
public class BadInputTests
{
    private static readonly string[] s_drawingVerbs = ["info", "table", "sequence"];

    public static TheoryData<string> DrawingVerbs => [.. s_drawingVerbs];

    [Theory]
    [MemberData(nameof(DrawingVerbs))]
    public async Task A_missing_file_is_one_error_and_exit_1(string verb)
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync(verb, folder.PathOf("nowhere.dxf"));

        AssertOneError(run, "DOC0001");
    }

    [Theory]
    [MemberData(nameof(DrawingVerbs))]
    public async Task An_empty_file_is_one_error_and_exit_1(string verb)
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync(verb, folder.WithFile("empty.dxf", ""));

        AssertOneError(run, "DXF");
    }

    [Theory]
    [MemberData(nameof(DrawingVerbs))]
    public async Task A_file_that_is_no_DXF_is_one_error_and_exit_1(string verb)
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync(verb, folder.WithFile("letter.dxf", "Dear Sir or Madam,\nthis is a letter.\n"));

        AssertOneError(run, "DXF");
    }

    [Theory]
    [InlineData("--jsonn", "info", "--jsonn", "part.dxf")]
    [InlineData("--jsonn", "info", "part.dxf", "--jsonn", "x")]
    [InlineData("--jsonn", "run", "--connect", "sim:", "--jsonn=x", "part.dxf")]
    [InlineData("-q", "plan", "-q", "part.dxf")]
    [InlineData("--fullscreen", "desktop", "--fullscreen")]
    public async Task An_unknown_option_is_named(string unknown, params string[] words)
    {
        var run = await CliRun.RunAsync(words);

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.StartsWith($"engraver: Unknown option {unknown}.", run.Error, StringComparison.Ordinal);
        Assert.Empty(run.Out);
    }

    [Fact]
    public async Task What_looks_like_an_option_behind_two_hyphens_is_a_file()
    {
        var run = await CliRun.RunAsync("info", "--", "--jsonn");

        Assert.Equal((ExitCode.DrawingError, true), (run.ExitCode, run.Error.Contains("--jsonn: error DOC0001", StringComparison.Ordinal)));
    }

    [Theory]
    [InlineData("plot", "picture.png")]
    [InlineData("report", "page.pdf")]
    [InlineData("sequence", "order.svg")]
    public async Task A_format_that_is_not_written_is_refused_by_name(string verb, string name)
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync(verb, SampleDrawing.PathOf("gasket"), "-o", folder.PathOf(name));

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Contains($"this verb does not write the format {Path.GetExtension(name)}.", run.Error, StringComparison.Ordinal);
        Assert.False(File.Exists(folder.PathOf(name)));
    }

    /// <summary>Messages of .NET contain type names, repeat the path and are always English.</summary>
    [Fact]
    public async Task A_missing_drawing_is_told_in_our_words_and_never_as_errors_that_can_be_accepted()
    {
        using var folder = new TemporaryFolder();
        foreach (var path in (string[])[folder.PathOf("nowhere.dxf"), folder.PathOf("no/folder.dxf")])
        {
            var run = await CliRun.RunAsync("run", path, "--connect", "sim:");

            Assert.Equal(ExitCode.DrawingError, run.ExitCode);
            Assert.Contains("does not exist.", run.Error, StringComparison.Ordinal);
            Assert.DoesNotContain("Could not find", run.Error, StringComparison.Ordinal);
            Assert.DoesNotContain("--accept-errors", run.Error, StringComparison.Ordinal);
        }
    }

    /// <summary>The result of an unset shell variable.</summary>
    [Theory]
    [InlineData("FILE is empty.", "plan", "")]
    [InlineData("FILE is empty.", "profile", "check", "")]
    [InlineData("FILE is empty.", "send", "", "--to", "serial:///dev/engraver-nothing")]
    [InlineData("JOURNAL is empty.", "replay", "")]
    [InlineData("--machine is empty.", "plan", "part.dxf", "--machine", "")]
    [InlineData("--journal is empty.", "run", "part.dxf", "--connect", "sim:", "--journal", "")]
    [InlineData("-o is empty.", "report", "part.dxf", "-o", "")]
    [InlineData("-o is empty.", "certify", "part.dxf", "-o", "")]
    public async Task An_empty_name_is_a_usage_error(string told, params string[] words)
    {
        var run = await CliRun.RunAsync(words);

        Assert.Equal((ExitCode.Usage, $"engraver: {told} See engraver --help.\n"), (run.ExitCode, run.Error));
    }

    [Fact]
    public async Task A_text_may_be_empty()
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("send", folder.WithFile("a.nc", "G0\n"), "--to", "serial:///dev/engraver-nothing", "--start-text", "");

        Assert.Equal(ExitCode.LinkLost, run.ExitCode);
    }

    [Theory]
    [InlineData("post", "--target", "galil")]
    [InlineData("certify")]
    [InlineData("report")]
    [InlineData("plot")]
    public async Task A_result_does_not_take_the_place_of_its_drawing(string verb, params string[] options)
    {
        using var folder = new TemporaryFolder();
        var text = await File.ReadAllTextAsync(SampleDrawing.PathOf("paper-001"));
        var drawing = folder.WithFile("part.dxf", text);
        var run = await CliRun.RunAsync([verb, drawing, .. options, "-o", folder.PathOf("./part.dxf")]);

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Contains("Specify another output file", run.Error, StringComparison.Ordinal);
        Assert.Equal(text, await File.ReadAllTextAsync(drawing));
    }

    [Fact]
    public async Task An_impossible_feed_is_the_fault_of_the_feed_and_not_of_the_profile()
    {
        var run = await CliRun.RunAsync("run", SampleDrawing.PathOf("paper-001"), "--connect", "sim:", "--feed", "1e9");

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Contains("--feed 1000000000 is outside the feed range of the machine, 0.12 to 720000 mm/min", run.Error, StringComparison.Ordinal);
        Assert.DoesNotContain("profile", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_truncated_file_is_exit_1_and_what_stands_before_the_cut_is_read()
    {
        using var folder = new TemporaryFolder();
        var whole = await File.ReadAllTextAsync(SampleDrawing.PathOf("paper-001"));
        var run = await CliRun.RunAsync("info", folder.WithFile("cut.dxf", whole[..whole.IndexOf("ARC\n", StringComparison.Ordinal)]), "--json");

        Assert.Equal(ExitCode.DrawingError, run.ExitCode);
        Assert.Equal(1, JsonText.Of(run).GetProperty("leaf").GetProperty("LINE").GetInt32());
        AssertNoStackTrace(run);
    }

    [Fact]
    public async Task A_folder_instead_of_a_file_is_exit_1()
    {
        var run = await CliRun.RunAsync("info", RepositoryFolder.Samples);

        AssertOneError(run, "DOC0001");
    }

    [Fact]
    public async Task An_unknown_layer_is_a_usage_error_that_names_the_layers_there_are()
    {
        var run = await CliRun.RunAsync("table", SampleDrawing.PathOf("nameplate"), "--layers", "Frame");

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Contains("'Frame'", run.Error, StringComparison.Ordinal);
        Assert.Contains("'Rahmen'", run.Error, StringComparison.Ordinal);
        AssertNoStackTrace(run);
    }

    [Theory]
    [InlineData("engrave")]
    [InlineData("info")]
    [InlineData("info", "FILE", "--layer-of-nobody")]
    [InlineData("info", "FILE", "--join-tolerance", "0,5")]
    [InlineData("info", "FILE", "--join-tolerance", "-1")]
    [InlineData("info", "FILE", "--max-error", "0")]
    [InlineData("info", "FILE", "--units", "furlong")]
    [InlineData("sequence", "FILE", "--order", "shortest")]
    [InlineData("sequence", "FILE", "--start", "1;2")]
    [InlineData("sequence", "FILE", "--enter", "xyz")]
    [InlineData("table", "FILE", "--format", "xml")]
    [InlineData("post", "FILE")]
    [InlineData("post", "FILE", "--target", "heidenhain")]
    [InlineData("run", "FILE")]
    [InlineData("run", "FILE", "--connect", "usb:1")]
    [InlineData("run", "FILE", "--connect", "serial:///dev/ttyS0?baud=19201")]
    [InlineData("run", "FILE", "--connect", "sim:", "--mode", "parallel")]
    [InlineData("run", "FILE", "--connect", "sim:", "--machine", "nowhere.json")]
    [InlineData("simulate", "--tcp", "99999")]
    [InlineData("simulate", "--speed", "fast")]
    [InlineData("info", "FILE", "--culture", "Klingon!!")]
    [InlineData("info", "FILE", "--culture", "xx-NOPE-ZZ")]
    [InlineData("info", "FILE", "--layers", "NOPE")]
    [InlineData("info", "FILE", "--cut", "point")]
    [InlineData("info", "FILE", "--cut", "3")]
    [InlineData("minimise", "FILE")]
    [InlineData("minimise", "FILE", "--keep", "DXF9999")]
    public async Task What_cannot_be_understood_is_exit_2_with_a_sentence(params string[] words)
    {
        var run = await CliRun.RunAsync([.. words.Select(word => word == "FILE" ? SampleDrawing.PathOf("paper-001") : word)]);

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.StartsWith("engraver: ", run.Error, StringComparison.Ordinal);
        Assert.Single(run.Error.TrimEnd().Split('\n'));
        AssertNoStackTrace(run);
    }

    [Fact]
    public async Task A_place_that_cannot_be_written_is_exit_2_and_leaves_nothing_behind()
    {
        using var folder = new TemporaryFolder();
        var run = await CliRun.RunAsync("post", SampleDrawing.PathOf("paper-001"), "--target", "galil", "-o", folder.PathOf("no/such/folder.dmc"));

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Contains("cannot be written", run.Error, StringComparison.Ordinal);
        AssertNoStackTrace(run);
    }

    [Fact]
    public async Task A_machine_profile_with_a_misspelt_field_names_the_field_and_its_line()
    {
        using var folder = new TemporaryFolder();
        var profile = folder.WithFile("machine.json", "{\n  \"feedMmPerMinute\": 600,\n  \"feeed\": 3\n}\n");
        var run = await CliRun.RunAsync("post", SampleDrawing.PathOf("paper-001"), "--target", "galil", "--machine", profile);

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Contains("feeed", run.Error, StringComparison.Ordinal);
        Assert.Contains("(3)", run.Error, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("inof", "Did you mean 'info'?")]
    [InlineData("sequnce", "Did you mean 'sequence'?")]
    [InlineData("PLOT", "Did you mean 'plot'?")]
    [InlineData("xyzzyx", "The verbs are info, ")]
    public async Task A_word_that_is_no_verb_is_answered_with_the_nearest_one(string word, string answer)
    {
        var run = await CliRun.RunAsync(word, "drawing.dxf");

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Contains(answer, Assert.Single(run.Error.TrimEnd().Split('\n')), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("galil")]
    [InlineData("galil-calls")]
    [InlineData("cldata")]
    public async Task Nothing_to_cut_is_nothing_to_post(string target)
    {
        using var folder = new TemporaryFolder();
        var points = folder.WithFile("points.dxf", "0\nSECTION\n2\nENTITIES\n0\nPOINT\n8\n0\n10\n0\n20\n0\n0\nENDSEC\n0\nEOF\n");
        var earlier = folder.WithFile("job.out", "earlier");

        var nothing = await CliRun.RunAsync("post", points, "--target", target, "-o", earlier);
        var missing = await CliRun.RunAsync("post", folder.PathOf("nowhere.dxf"), "--target", target, "-o", earlier);

        Assert.Equal((ExitCode.DrawingError, ExitCode.DrawingError), (nothing.ExitCode, missing.ExitCode));
        Assert.Contains("error DOC0002", nothing.Error, StringComparison.Ordinal);
        AssertOneError(missing, "DOC0001");
        Assert.Equal("earlier", await File.ReadAllTextAsync(earlier));
    }

    [Fact]
    public async Task A_result_that_cannot_be_written_is_one_sentence_and_exit_1()
    {
        await using var error = new StringWriter();
        int code;
        using (var streams = new ConsoleStreams(new FullStream(), error))
        {
            code = await EngraverProgram.RunAsync(["info", SampleDrawing.PathOf("paper-001"), "--quiet"], streams, CancellationToken.None);
        }

        Assert.Equal(ExitCode.DrawingError, code);
        Assert.Equal("engraver: the result cannot be written: No space left on device.", error.ToString().TrimEnd());
    }

    private static void AssertOneError(CliRun run, string id)
    {
        Assert.Equal(ExitCode.DrawingError, run.ExitCode);
        var line = Assert.Single(run.Error.TrimEnd().Split('\n'));
        Assert.Contains($": error {id}", line, StringComparison.Ordinal);
        AssertNoStackTrace(run);
    }

    private static void AssertNoStackTrace(CliRun run) => Assert.DoesNotContain("   at ", run.Error + run.Out, StringComparison.Ordinal);
}
