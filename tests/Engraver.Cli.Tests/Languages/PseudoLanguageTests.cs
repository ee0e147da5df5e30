using System.CommandLine;
using System.CommandLine.Help;
using System.Globalization;
using Engraver.Cli.Options;
using Engraver.Core.Languages;
using Engraver.TestKit;

namespace Engraver.Cli.Tests.Languages;

/// <summary>The runner in the pseudo-language: help of every verb, displayed results, refusals. An unmarked letter is text that cannot be translated.</summary>
public class PseudoLanguageTests
{
    /// <summary>The program's name, units, and texts of the command line library.</summary>
    private static readonly string[] s_stays = ["engraver", "mm", "s", "x"];

    public static TheoryData<string> Runs =>
    [
        "info {gasket}", "info {gasket} --twice --verbose", "info none.dxf", "info {folder}", "info {gasket} --layers nothing", "info {gasket} --units parsec", "info {gasket} --cut soup",
        "sequence {nameplate} --verbose", "sequence {gasket} --enter nothing", "sequence {gasket} --enter FFFF", "sequence {gasket} --start there",
        "plan {gasket}", "plan {gasket} --feed 0", "plan {gasket} --feed 1e9", "plan {gasket} --machine none.json", "plan {gasket} --connect nowhere",
        "plot {gasket} -o {folder}/a.svg", "plot {gasket} -o {folder}/none/a.svg", "post {gasket} --target galil -o {folder}/a.dmc", "post {gasket} --target punched-tape", "post {gasket} --target gcode --dialect grbl --tool-switch m64",
        "verify {folder}/b.dmc --against {gasket}", "verify none.dmc --against {gasket}", "table {gasket} --format csv -o", "minimise {gasket} --keep DXF0001", "minimise {gasket} --keep soup", "minimise none.dxf --keep crash",
        "run {paper-001} --connect sim:", "run {paper-001} --connect sim: --dry-run --mode calls", "run {empty} --connect sim:", "run {paper-001} --connect tcp://127.0.0.1:1", "run {paper-001} --connect sim: --trace {folder}/none/t", "run {paper-001} --connect sim: --mode walk",
        "simulate --tcp 99999", "simulate --baud 9600", "simulate --speed slow", "simulate --numbers none", "simulate --faults none.json", "terminal --connect nowhere", "terminal --connect tcp://127.0.0.1:1",
        "info {folder}/repaired.dxf --twice", "info {folder}/damaged.dxf --twice", "info {folder}/array.dxf --twice", "info {folder}/circle.dxf --twice",
        "commission --connect nowhere", "commission --connect sim:", "commission --connect sim: --machine none.json", "script {folder}/none.scr", "script {folder}/a.scr", "desktop --soup", "bench 0", "inof", "soup", "info", "info --culture",
    ];

    [Fact]
    public void Every_verb_option_and_argument_is_described_in_the_language()
    {
        var before = CultureInfo.CurrentUICulture;
        CultureInfo.CurrentUICulture = new CultureInfo(PseudoLanguage.CultureName);
        try
        {
            using var streams = new ConsoleStreams(Stream.Null, TextWriter.Null, TextReader.Null);
            var root = EngraverCommandLine.Build(streams, new GlobalOptions(), new ConnectionGuard());
            var described = Symbols(root).Where(symbol => symbol is not (HelpOption or VersionOption)).ToList();

            Assert.InRange(described.Count, 80, 1000);
            Assert.All(described, symbol => Assert.True(symbol.Description is { Length: > 0 } text && PseudoLanguage.UnmarkedWords(text).Count == 0, $"{symbol.Name}: {symbol.Description}"));
        }
        finally
        {
            CultureInfo.CurrentUICulture = before;
        }
    }

    [Theory]
    [MemberData(nameof(Runs))]
    public async Task Every_run_is_told_in_the_language(string words)
    {
        using var folder = new TemporaryFolder();
        folder.WithFile("empty.dxf", "");
        folder.WithFile("b.dmc", "#JOB\nSOUP\nEN\n");
        folder.WithFile("a.scr", "LINE\nMOVE\n");
        folder.WithFile("repaired.dxf", "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n1,5\n20\n0\n11\n3\n21\n0\n0\nENDSEC\n0\nEOF\n");
        folder.WithFile("damaged.dxf", "0\nSECTION\n2\nENTITIES\n0\nENDSEC\n10\n0\n0\nEOF\n");
        folder.WithFile("array.dxf", "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nB\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n3\n21\n0\n0\nENDBLK\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nINSERT\n2\nB\n10\n0\n20\n0\n70\n32000\n71\n32000\n0\nENDSEC\n0\nEOF\n");
        folder.WithFile("circle.dxf", "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nB\n0\nINSERT\n2\nB\n10\n0\n20\n0\n0\nENDBLK\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nINSERT\n2\nB\n10\n0\n20\n0\n0\nENDSEC\n0\nEOF\n");
        string[] args = [.. words.Split(' ').Select(word => word.Replace("{folder}", folder.PathOf(""), StringComparison.Ordinal).Replace("{empty}", folder.PathOf("empty.dxf"), StringComparison.Ordinal)).Select(word => word.StartsWith('{') ? SampleDrawing.PathOf(word.Trim('{', '}')) : word)];
        var run = await CliRun.RunAsync([.. args, "--culture", PseudoLanguage.CultureName]);

        var shown = run.Error.Split('\n').Concat(words.StartsWith("table", StringComparison.Ordinal) ? [] : run.Out.Split('\n')).ToList();
        Assert.DoesNotContain(shown, IsForeign);
        Assert.DoesNotContain(shown, HiddenSentence.IsIn);
        Assert.True(words.StartsWith('p') || shown.Any(line => line.AsSpan().ContainsAny('⟦', '‹')), "nothing was said");
    }

    [Fact]
    public async Task The_terminal_speaks_it()
    {
        var run = await CliRun.Typing("help\nhelp VP\nhelp 22\nhelp soup\nRS\nVM\nED\nsoup\nMG 1\nquit\n", "terminal", "--connect", "sim:", "--culture", PseudoLanguage.CultureName);

        Assert.DoesNotContain((run.Out + run.Error).Split('\n'), IsForeign);
    }

    private static bool IsForeign(string line) => PseudoLanguage.UnmarkedWords(line).Except(s_stays).Any();

    private static IEnumerable<Symbol> Symbols(Command command) => [command, .. command.Options, .. command.Arguments, .. command.Subcommands.SelectMany(Symbols)];
}
