using Engraver.Architecture.Tests.Sources;
using Engraver.TestKit;

namespace Engraver.Architecture.Tests.Structure;

/// <summary>No new circle between the folders of a project. Those that exist are listed in circles.txt, which may only become shorter.</summary>
public class FolderCircleTests
{
    private const string ListName = "tests/Engraver.Architecture.Tests/Structure/circles.txt";

    private static readonly Lazy<IReadOnlyList<string>> s_found = new(() => [.. FolderCircles.Find(SourceFile.Under("src", ".cs")).Select(circle => circle.ToString())]);

    [Fact]
    public void No_circle_appears_that_is_not_listed()
    {
        var fresh = s_found.Value.Except(Listed()).ToList();
        Assert.True(fresh.Count == 0, $"Folders that name each other's types, and are not in {ListName}. Move the type to the folder that owns the word, or turn the arrow round by an interface or an argument:\n{string.Join('\n', fresh)}");
    }

    [Fact]
    public void A_circle_that_was_opened_leaves_the_list()
    {
        var gone = Listed().Except(s_found.Value).ToList();
        Assert.True(gone.Count == 0, $"No longer found as listed; take the line out of {ListName}, or put the smaller circle in its place:\n{string.Join('\n', gone)}");
    }

    [Fact]
    public void Two_folders_that_name_each_other_are_a_circle()
    {
        SourceFile[] files = [new("src/P/A/One.cs", "class One { Two x; }"), new("src/P/B/Two.cs", "class Two { One y; }"), new("src/P/C/Three.cs", "class Three { One z; } // Four"), new("src/P/D/Four.cs", "class Four { Three t; }")];
        Assert.Equal("src/P: A B", Assert.Single(FolderCircles.Find(files)).ToString());
    }

    private static List<string> Listed() => [.. File.ReadAllLines(Path.Combine(RepositoryFolder.Root, ListName)).Where(line => line.Length > 0 && line[0] != '#')];
}
