using System.CommandLine;
using System.Text.RegularExpressions;
using Engraver.Cli.Options;
using Engraver.TestKit;

namespace Engraver.Cli.Tests.Verbs;

/// <summary>Help and contract page list exactly the verbs and options of the program.</summary>
public sealed partial class HelpTests
{
    public static TheoryData<string> Verbs => [.. Root().Subcommands.Select(verb => verb.Name)];

    [Theory]
    [MemberData(nameof(Verbs))]
    public async Task Help_shows_no_words_of_the_runtime(string verb)
    {
        var run = await CliRun.RunAsync(verb, "--help");

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.DoesNotContain("{ ", run.Out, StringComparison.Ordinal);
        Assert.DoesNotContain("System.", run.Out, StringComparison.Ordinal);
        Assert.DoesNotContain("Engraver.", run.Out, StringComparison.Ordinal);
    }

    [Fact]
    public void The_contract_names_no_option_that_is_not_built()
    {
        var known = All(Root()).SelectMany(command => command.Options).SelectMany(option => option.Aliases.Append(option.Name)).ToHashSet();
        var contract = File.ReadAllText(Path.Combine(RepositoryFolder.Root, "docs", "cli-contract.md"));

        var unknown = OptionName().Matches(contract).Select(match => match.Value).Distinct().Where(name => !known.Contains(name)).ToList();

        Assert.Contains("--connect", OptionName().Matches(contract).Select(match => match.Value));
        Assert.Empty(unknown);
    }

    [Fact]
    public void The_page_of_verbs_is_the_command_line() => GoldenFile.Check(Path.Combine(RepositoryFolder.Root, "docs", "verbs.md"), VerbPage.Of(Root()));

    [Fact]
    public void The_page_of_exit_codes_has_every_code()
    {
        var codes = typeof(ExitCode).GetFields().Where(field => field.IsLiteral).Select(field => (int)field.GetRawConstantValue()!);
        var page = File.ReadAllLines(Path.Combine(RepositoryFolder.Root, "docs", "exit-codes.md"));

        Assert.Equal(codes.Append(6).Order(), page.Select(line => Regex.Match(line, @"^\| (\d+) \|")).Where(row => row.Success).Select(row => int.Parse(row.Groups[1].Value, System.Globalization.CultureInfo.InvariantCulture)));
    }

    [Theory]
    [InlineData("--cut")]
    [InlineData("--order")]
    public void The_contract_offers_the_values_that_are_taken(string option)
    {
        var contract = File.ReadAllText(Path.Combine(RepositoryFolder.Root, "docs", "cli-contract.md"));
        var offered = Regex.Match(contract, $"`{option} ([a-z]+(?:[,|][a-z]+)+)`").Groups[1].Value.Split(',', '|');

        Assert.True(offered.Length > 1);
        foreach (var value in offered) Assert.Empty(Root().Parse(["plan", "part.dxf", option, value]).Errors);
    }

    private static IEnumerable<Command> All(Command command) => command.Subcommands.SelectMany(All).Prepend(command);

    private static RootCommand Root() => EngraverCommandLine.Build(new ConsoleStreams(Stream.Null, TextWriter.Null, TextReader.Null), new GlobalOptions(), new ConnectionGuard());

    [GeneratedRegex("(?<=[` (\\[|/])--[a-z][a-z-]+[a-z]")]
    private static partial Regex OptionName();
}
