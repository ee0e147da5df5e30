using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Tests.Commands;

namespace Engraver.Workbench.Tests.CommandLanguage;

/// <summary>File names as typed or pasted.</summary>
public class FileNameTests
{
    private static readonly string s_home = Environment.GetFolderPath(Environment.SpecialFolder.UserProfile, Environment.SpecialFolderOption.DoNotVerify);

    [Theory]
    [InlineData("plate.dxf", "plate.dxf")]
    [InlineData("\"my plate.dxf\"", "my plate.dxf")]
    [InlineData("'my plate.dxf'", "my plate.dxf")]
    [InlineData("5\" plate.dxf", "5\" plate.dxf")]
    [InlineData("\"", "\"")]
    [InlineData("a~b.dxf", "a~b.dxf")]
    [InlineData("~plate.dxf", "~plate.dxf")]
    [InlineData("file:///tmp/my%20plate.dxf", "/tmp/my plate.dxf")]
    public void Quotes_and_addresses_are_read(string typed, string name) => Assert.Equal(name, TypedFileName.Parse(typed));

    [Fact]
    public void The_home_folder_is_a_tilde()
    {
        Assert.Equal(s_home, TypedFileName.Parse("~"));
        Assert.Equal(Path.Combine(s_home, "a", "b.dxf"), TypedFileName.Parse("\"~/a/b.dxf\""));
    }

    [Theory]
    [InlineData("/tmp/plate.dxf")]
    [InlineData("/tmp/my plate.dxf")]
    [InlineData("'plate'")]
    [InlineData("\"plate\"")]
    [InlineData("/tmp/plate ")]
    public void What_is_written_is_read_back(string path) => Assert.Equal(path, TypedFileName.Parse(TypedFileName.Format(path)));

    [Theory]
    [InlineData("plate", "plate.dxf")]
    [InlineData("plate.", "plate.dxf")]
    [InlineData("plate.v2", "plate.v2.dxf")]
    [InlineData("plate.DXF", "plate.DXF")]
    [InlineData("folder/", "folder/")]
    [InlineData("/dev/stdout", "/dev/stdout")]
    public void The_usual_ending_is_added_where_none_fits(string typed, string name) => Assert.Equal(name, new FileRequest(FileRequest.Drawing, true, ".dxf").WithExtension(typed));

    [Fact]
    public async Task SAVEAS_adds_the_ending_and_asks_about_that_file()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await File.WriteAllTextAsync(talk.PathOf("my plate.dxf"), "old");
        await talk.TypeAsync("SAVEAS", "\"my plate\"");
        Assert.True(talk.Session.Prompt.ConfirmsReplacing);
        await talk.TypeAsync("Yes");

        Assert.NotEqual("old", await File.ReadAllTextAsync(talk.PathOf("my plate.dxf")));
        Assert.Equal(talk.PathOf("my plate.dxf"), talk.Session.Document.FilePath);
    }

    [Fact]
    public async Task OPEN_takes_a_name_in_quotes_and_tells_a_missing_file_once()
    {
        await using var talk = new CommandTestSession();
        File.Copy(CommandTestSession.Sample("paper-001.dxf"), talk.PathOf("my plate.dxf"));
        await talk.TypeAsync("OPEN", "'my plate.dxf'");
        Assert.Equal(4, talk.State.Drawing!.Entities.Count);

        var failed = Assert.IsType<InputResult.Failed>(await talk.TypeAsync("OPEN", "missing.dxf"));
        Assert.Single(talk.Said.Split('\n'), line => line.Contains("missing.dxf", StringComparison.Ordinal));
        Assert.Contains("missing.dxf was not opened", failed.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void The_folder_of_each_kind_is_kept_in_the_file_of_the_settings()
    {
        var folder = Directory.CreateTempSubdirectory("settings-");
        var path = Path.Combine(folder.FullName, "desktop.json");
        SettingsFile.Save(path, DesktopSettings.Default.WithFileFolder("drawing", "/a").WithFileFolder("script", "/b").WithFileFolder("drawing", "/c"));
        var read = SettingsFile.Load(path, TimeProvider.System).Settings.FileFolders;
        File.WriteAllText(path, """{ "fileFolders": null }""");

        Assert.Equal([("drawing", "/c"), ("script", "/b")], read.Select(pair => (pair.Key, pair.Value)));
        Assert.Empty(SettingsFile.Load(path, TimeProvider.System).Settings.FileFolders);
        folder.Delete(recursive: true);
    }

    [Theory]
    [InlineData("\"my plate", true)]
    [InlineData("/tmp/my", true)]
    [InlineData("~/my", true)]
    [InlineData("C:\\my", true)]
    [InlineData("\\\\server\\my", true)]
    [InlineData("file:///tmp/my", true)]
    [InlineData("my", false)]
    [InlineData("", false)]
    [InlineData("-LAYER", false)]
    [InlineData("_LINE", false)]
    [InlineData("'ZOOM", false)]
    [InlineData("@10<45", false)]
    [InlineData("10,20", false)]
    public void A_path_is_known_by_its_beginning(string typed, bool isPath) => Assert.Equal(isPath, TypedFileName.IsPath(typed));
}
