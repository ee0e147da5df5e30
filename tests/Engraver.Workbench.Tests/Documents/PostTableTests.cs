using Engraver.Core.Machines;
using Engraver.TestKit;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Tests.Commands;

namespace Engraver.Workbench.Tests.Documents;

/// <summary>One table of posts, used by console, command window and documentation.</summary>
public class PostTableTests
{
    public static TheoryData<string> Names => [.. PostTable.All.Select(entry => entry.Post.Name)];

    [Fact]
    public void The_page_is_the_table() => GoldenFile.Check(Path.Combine(RepositoryFolder.Root, "docs", "posts.md"), PostTable.ToMarkdown());

    [Fact]
    public void Names_and_short_forms_are_each_once_and_a_keyword_is_its_posts_name()
    {
        Assert.All(PostTable.All, entry => Assert.Equal(entry.Post.Name, entry.Keyword, ignoreCase: true));
        Assert.Equal(PostTable.All.Count, PostTable.All.Select(entry => entry.Post.Name).Distinct().Count());
        Assert.Equal(PostTable.All.Count, PostTable.All.Select(entry => new Keyword(entry.Keyword).Abbreviation).Distinct().Count());
        Assert.Equal(PostTable.Choices.Count, PostTable.Choices.Select(choice => new Keyword(choice.Keyword).Abbreviation).Distinct().Count());
        Assert.Equal(PostTable.All.Sum(entry => Math.Max(1, entry.Dialects.Count)), PostTable.Choices.Count);
        Assert.All(PostTable.All, entry => Assert.Matches(@"^\.[a-z]+$", entry.Post.FileExtension));
        Assert.All(PostTable.All, entry => Assert.DoesNotMatch(@"[.|]$", entry.Post.Summary));
    }

    [Fact]
    public void Two_posts_with_an_option_of_one_name_mean_the_same_by_it() => Assert.All(PostTable.All.SelectMany(entry => entry.Post.Options), option =>
    {
        Assert.Equal(PostTable.Options.Single(one => one.Name == option.Name), option);
        Assert.True(option.IsValid(option.Default));
        Assert.False(option.IsValid("") || option.IsValid("nonsense"));
    });

    [Theory]
    [MemberData(nameof(Names))]
    public async Task POST_writes_every_entry_as_the_console_does(string name)
    {
        await using var talk = new CommandTestSession();
        var file = talk.PathOf("out.txt");
        var sample = name.StartsWith("xps", StringComparison.Ordinal) ? "paper-001" : "gasket"; // Splines take long to verify.
        await talk.TypeAsync("OPEN", CommandTestSession.Sample(sample + ".dxf"), "POST", name, file);

        Assert.Equal(PostedProgram.Create(Open(sample), new DrawingSettings(), PostTable.Find(name).Post, PostedProgram.NoOptions).Text, await File.ReadAllTextAsync(file));
    }

    [Theory]
    [InlineData("galil")]
    [InlineData("galil-calls")]
    public void A_smaller_memory_gives_more_chunks_and_none_is_longer(string name)
    {
        var options = new Dictionary<string, string> { ["memory"] = "100" };
        var chunks = PostedProgram.Create(Open("nameplate"), new DrawingSettings(), PostTable.Find(name).Post, options).Text!.Split("'CHUNK ", StringSplitOptions.RemoveEmptyEntries);

        Assert.True(chunks.Length > 1);
        Assert.All(chunks, chunk => Assert.InRange(chunk.Count(c => c == '\n'), 10, 100));
    }

    /// <summary>The format of a file is detected from its content, also with an unknown or wrong extension.</summary>
    [Fact]
    public void A_posted_file_is_known_by_how_it_begins_and_otherwise_by_its_ending()
    {
        var folder = Directory.CreateTempSubdirectory("engraver-forms-");
        string PathOf(string name) => Path.Combine(folder.FullName, name);
        foreach (var choice in PostTable.Choices)
        {
            var file = PathOf("program.txt");
            File.WriteAllText(file, PostedProgram.Create(Open("paper-001"), new DrawingSettings(), choice.Entry.Post, choice.Options).Text);
            var found = ProgramFormatDetector.Of(file);
            Assert.Equal(choice.Name == "galil-calls" ? "galil" : choice.Name, found?.Name);
            Assert.Same(choice.Dialect is null ? PostTable.Find(found!.Entry.Post.Name).Reader : choice.Entry.Dialects[choice.Dialect], found!.Reader);
        }

        File.WriteAllText(PathOf("empty.NGC"), "\n");
        Assert.Equal("gcode linuxcnc", ProgramFormatDetector.Of(PathOf("empty.NGC"))?.Name);
        Assert.Equal("galil", ProgramFormatDetector.Of(PathOf("none.DMC"))?.Name);
        Assert.Null(ProgramFormatDetector.Of(PathOf("none.txt")));
        folder.Delete(recursive: true);
        Assert.All(PostTable.All, entry => Assert.NotNull(entry.Reader));
        Assert.Throws<KeyNotFoundException>(() => PostTable.Find("punched-tape"));
        Assert.Equal(MotionStyle.Calls, PostTable.ForMotion(MachineFamilies.Default, MotionStyle.Calls)!.Post.Motion);
    }

    private static Core.Drawings.Drawing Open(string sample) => DrawingFile.Open(CommandTestSession.Sample(sample + ".dxf"), new DrawingSettings(), CancellationToken.None);
}
