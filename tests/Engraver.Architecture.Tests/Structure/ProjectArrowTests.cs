using System.Text.RegularExpressions;
using Engraver.TestKit;

namespace Engraver.Architecture.Tests.Structure;

/// <summary>Projects reference each other as listed in docs/architecture.md: in the project file, and in the compiled assembly.</summary>
public class ProjectArrowTests
{
    public static TheoryData<string> Projects => [.. Directory.GetDirectories(Path.Combine(RepositoryFolder.Root, "src")).Select(folder => Path.GetFileName(folder)!).Where(name => !IsBuildOutput(name))];

    [Theory]
    [MemberData(nameof(Projects))]
    public void A_project_file_names_only_what_the_page_allows(string project)
    {
        var rule = RuleOf(project);
        var text = File.ReadAllText(Path.Combine(RepositoryFolder.Root, "src", project, project + ".csproj"));
        var references = Regex.Matches(text, @"ProjectReference\s+Include=""[^""]*?([\w.]+)\.csproj""").Select(found => found.Groups[1].Value);
        var packages = Regex.Matches(text, @"PackageReference\s+Include=""([^""]+)""").Select(found => found.Groups[1].Value);

        Assert.Empty(references.Except(rule.MayReference));
        Assert.Empty(packages.Except(rule.Packages));
    }

    [Theory]
    [MemberData(nameof(Projects))]
    public void An_assembly_references_only_what_its_project_may_reach(string project)
    {
        using var assembly = BuiltAssembly.Open(project);
        if (assembly is null)
        {
            Assert.True(project == "Engraver.SoftwarePlatform" && !OperatingSystem.IsLinux(), $"{project} was not built beside the tests.");
            return;
        }

        var reachable = Reachable(project).ToHashSet();
        var foreign = assembly.References.Where(name => name.StartsWith("Engraver.", StringComparison.Ordinal) && !reachable.Contains(name)).ToList();
        Assert.True(foreign.Count == 0, $"{project} uses {string.Join(", ", foreign)}.");
        if (!RuleOf(project).Packages.Contains("Avalonia")) Assert.DoesNotContain(assembly.References, name => name.StartsWith("Avalonia", StringComparison.Ordinal));
    }

    /// <summary>Links are opened in Engraver.Links and passed to a driver.</summary>
    [Theory]
    [InlineData("Engraver.Core")]
    [InlineData("Engraver.Galil")]
    public void No_stage_and_no_driver_opens_a_link(string project)
    {
        using var assembly = BuiltAssembly.Open(project);

        Assert.DoesNotContain(assembly!.References, name => name is "System.Net.Sockets" or "System.IO.Ports");
    }

    [Fact]
    public void The_simulated_controller_stands_alone() => Assert.Empty(RuleOf("Engraver.Simulator").MayReference);

    private static ProjectRule RuleOf(string project) => ProjectRule.All.SingleOrDefault(rule => rule.Project == project) ?? throw new InvalidOperationException($"docs/architecture.md has no row for {project}.");

    private static IEnumerable<string> Reachable(string project) => RuleOf(project).MayReference.SelectMany(next => Reachable(next).Prepend(next));

    private static bool IsBuildOutput(string name) => name is "bin" or "obj" or "artifacts";
}
