using Engraver.TestKit;

namespace Engraver.Architecture.Tests.Packages;

/// <summary>The notices of third parties name every package that is delivered with the two programs, and are delivered with them.</summary>
public class NoticeTests
{
    private static readonly NoticeFile s_notices = new();

    /// <summary>On Windows and macOS Avalonia's back ends select the versions of the native libraries, so only the names are compared.</summary>
    [Theory]
    [InlineData("Engraver.Cli", "System.CommandLine")]
    [InlineData("Engraver.App", "Avalonia")]
    public void Every_delivered_package_has_its_row(string project, string one)
    {
        var delivered = DeliveredPackages.Of(project);
        Assert.Contains(delivered, package => package.Id == one);

        var rows = s_notices.Rows.Where(row => !OperatingSystem.IsLinux() || row.Version != NoticeFile.RequiredByAvalonia).ToLookup(row => row.Id);
        var missing = delivered.Where(package => !rows[package.Id].Any(row => !OperatingSystem.IsLinux() || row.Version == package.Version)).ToList();

        Assert.True(missing.Count == 0, $"{NoticeFile.Name} has no row for {string.Join(", ", missing.Select(package => $"{package.Id} {package.Version}"))}.");
    }

    [Fact]
    public void Every_licence_of_a_row_is_in_the_file_once()
    {
        Assert.NotEmpty(s_notices.Rows);
        Assert.Equal(s_notices.Rows.Select(row => row.Licence).Distinct().Order(StringComparer.Ordinal), s_notices.Licences.Order(StringComparer.Ordinal));
    }

    [Fact]
    public void A_package_has_one_row() => Assert.Equal(s_notices.Rows.Count, s_notices.Rows.Select(row => row.Id + row.Version).Distinct().Count());

    /// <summary>Skia and HarfBuzz contain further libraries, and ScottPlot further sources, whose notices their packages reproduce.</summary>
    [Theory]
    [InlineData("libpng")]
    [InlineData("freetype")]
    [InlineData("HarfBuzz")]
    [InlineData("Colormaps/Turbo.cs")]
    public void Libraries_inside_of_packages_have_their_notices(string library) => Assert.True(s_notices.Contains($"# {library}\n") || s_notices.Contains($"#   {library}\n"), library);

    [Theory]
    [InlineData("Engraver.Cli")]
    [InlineData("Engraver.App")]
    public void A_published_program_contains_licence_and_notices(string project)
    {
        var text = File.ReadAllText(Path.Combine(RepositoryFolder.Root, "src", project, project + ".csproj"));

        Assert.Contains($"<None Include=\"../../LICENSE;../../{NoticeFile.Name}\" CopyToPublishDirectory=\"PreserveNewest\" />", text, StringComparison.Ordinal);
    }
}
