using System.Diagnostics;
using System.IO.Compression;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using Engraver.Architecture.Tests.Sources;
using Engraver.TestKit;

namespace Engraver.Architecture.Tests.Packages;

/// <summary>The packages of docs/library.md.</summary>
public class PackageTests
{
    public static TheoryData<string> Packages => ["Engraver.Core", "Engraver.Simulator"];

    [Fact]
    public void Only_the_two_libraries_can_be_packed()
    {
        var packable = SourceFile.Under("", ".csproj", ".props").Where(file => file.Text.Contains("<IsPackable>true", StringComparison.Ordinal)).Select(file => Path.GetFileNameWithoutExtension(file.FileName));

        Assert.Equal(["Engraver.Core", "Engraver.Simulator"], packable.Order(StringComparer.Ordinal));
        Assert.Contains("<IsPackable>false", SourceFile.Read(Path.Combine(RepositoryFolder.Root, "Directory.Build.props")).Text, StringComparison.Ordinal);
    }

    [Fact]
    public void The_samples_in_the_packages_are_those_of_the_page() =>
        Assert.Equal(LibraryPage.Classes.Select(sample => sample.Code), [LibraryPage.SampleOf("Engraver.Simulator"), LibraryPage.SampleOf("Engraver.Core")]);

    /// <summary>Otherwise the sample cannot be restored from the packages of this repository.</summary>
    [Fact]
    public void The_project_of_the_page_uses_the_test_packages_of_this_repository()
    {
        var central = XDocument.Load(Path.Combine(RepositoryFolder.Root, "Directory.Packages.props")).Descendants("PackageVersion").ToDictionary(package => (string)package.Attribute("Include")!, package => (string)package.Attribute("Version")!);
        var used = XDocument.Parse(LibraryPage.Project).Descendants("PackageReference").Select(package => ((string)package.Attribute("Include")!, (string)package.Attribute("Version")!)).Where(package => !package.Item1.StartsWith("Engraver.", StringComparison.Ordinal)).ToList();

        Assert.NotEmpty(used);
        Assert.All(used, package => Assert.Equal(central[package.Item1], package.Item2));
    }

    /// <summary>Makes both packages from the sources, then builds and runs the project of docs/library.md outside of the repository.</summary>
    /// <remarks>A commit runs the comparisons above; this test builds everything again and takes a minute.</remarks>
    [FullRunFact]
    public async Task A_foreign_test_project_uses_both_packages()
    {
        var folder = Directory.CreateTempSubdirectory("engraver-packages-");
        try
        {
            var packages = folder.CreateSubdirectory("packages").FullName;
            foreach (var package in Packages) await DotnetAsync(folder.FullName, "pack", Path.Combine(RepositoryFolder.Root, "src", package), "-c", "Release", "-o", packages, $"-p:ArtifactsPath={Path.Combine(folder.FullName, "build")}", "-p:RunAnalyzers=false");
            foreach (var package in Packages) LooksComplete(package, packages);

            var project = folder.CreateSubdirectory("StageTests").FullName;
            File.WriteAllText(Path.Combine(project, "StageTests.csproj"), LibraryPage.Project);
            foreach (var (name, code) in LibraryPage.Classes) File.WriteAllText(Path.Combine(project, name + ".cs"), code);
            File.Copy(Path.Combine(RepositoryFolder.Samples, "paper-001.dxf"), Path.Combine(project, "drawing.dxf"));
            await UseOnlyAsync(packages, project);
            var said = await DotnetAsync(project, "test", "-nologo");

            Assert.Matches(@"Passed:\s+2\b", said);
        }
        finally
        {
            folder.Delete(recursive: true);
        }
    }

    private static void LooksComplete(string package, string folder)
    {
        using var made = ZipFile.OpenRead(Assert.Single(Directory.GetFiles(folder, package + ".*.nupkg")));
        string[] expected = [$"lib/net10.0/{package}.dll", $"lib/net10.0/{package}.xml", "README.md"];
        Assert.Empty(expected.Except(made.Entries.Select(entry => entry.FullName)));
        using var description = made.GetEntry(package + ".nuspec")!.Open();
        var nuspec = XDocument.Load(description).Root!;
        string Of(string name) => nuspec.Descendants().SingleOrDefault(element => element.Name.LocalName == name)?.Value ?? "";
        Assert.Equal((package, "MIT", "README.md"), (Of("id"), Of("license"), Of("readme")));
        Assert.All(["description", "tags", "authors", "copyright"], name => Assert.NotEmpty(Of(name)));
        Assert.DoesNotContain(nuspec.Descendants(), element => element.Name.LocalName == "dependency");
        using var symbols = ZipFile.OpenRead(Assert.Single(Directory.GetFiles(folder, package + ".*.snupkg")));
        Assert.Contains(symbols.Entries, entry => entry.FullName == $"lib/net10.0/{package}.pdb");
    }

    /// <summary>Restores the new packages, and the others from those that this repository has restored, without a network.</summary>
    /// <remarks>The new packages are restored into a folder of the project, because a later run makes other packages with the same version.</remarks>
    private static async Task UseOnlyAsync(string packages, string project)
    {
        var restored = Regex.Match(await DotnetAsync(project, "nuget", "locals", "global-packages", "--list"), @"global-packages: (.+)").Groups[1].Value.Trim();
        var settings = new XElement("configuration",
            new XElement("packageSources", new XElement("clear"), Add("engraver", packages)),
            new XElement("fallbackPackageFolders", Add("repository", restored)),
            new XElement("config", Add("globalPackagesFolder", Path.Combine(project, "restored"))));
        File.WriteAllText(Path.Combine(project, "nuget.config"), settings.ToString());
    }

    private static XElement Add(string key, string value) => new("add", new XAttribute("key", key), new XAttribute("value", value));

    private static async Task<string> DotnetAsync(string folder, params string[] words)
    {
        var start = new ProcessStartInfo("dotnet", words) { WorkingDirectory = folder, RedirectStandardOutput = true, RedirectStandardError = true };
        foreach (var name in start.Environment.Keys.Where(name => name.StartsWith("MSBUILD", StringComparison.OrdinalIgnoreCase) || name.StartsWith("VSTEST", StringComparison.OrdinalIgnoreCase)).ToList()) start.Environment.Remove(name);
        // No process may remain that would keep the output open.
        start.Environment["MSBUILDDISABLENODEREUSE"] = "1";
        start.Environment["UseSharedCompilation"] = "false";
        using var process = Process.Start(start)!;
        var (said, complained) = (process.StandardOutput.ReadToEndAsync(), process.StandardError.ReadToEndAsync());
        await process.WaitForExitAsync();
        var output = await said + await complained;
        Assert.True(process.ExitCode == 0, $"dotnet {string.Join(' ', words)}\n{output}");
        return output;
    }
}
