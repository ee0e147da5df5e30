using Engraver.Architecture.Tests.Sources;

namespace Engraver.Architecture.Tests.Structure;

/// <summary>One file has one subject, and the files of a folder fit on one screen (docs/architecture.md, "Folders"). Blank lines are not counted.</summary>
public class FolderSizeTests
{
    private const int MostFiles = 25;
    private const int FewLines = 16;
    private const int MostLines = 400;

    private static readonly Lazy<IReadOnlyList<SourceFile>> s_files = new(() => SourceFile.Under("src", ".cs"));

    [Fact]
    public void No_folder_holds_more_than_25_files_at_one_level()
    {
        var full = s_files.Value.GroupBy(file => Path.GetDirectoryName(file.Name)!).Where(folder => folder.Count() > MostFiles).Select(folder => $"{folder.Key}: {folder.Count()}").ToList();
        Assert.True(full.Count == 0, $"Divide by the nouns that are in it:\n{string.Join('\n', full)}");
    }

    [Fact]
    public void Fewer_than_a_tenth_of_the_files_have_under_16_lines()
    {
        var small = s_files.Value.Where(file => Lines(file) < FewLines).ToList();
        Assert.True(
            10 * small.Count < s_files.Value.Count,
            $"{small.Count} of {s_files.Value.Count} files. A record, enum or result that serves one neighbour stands in the neighbour's file:\n{string.Join('\n', small.Select(file => file.Name))}");
    }

    [Fact]
    public void No_file_has_more_than_400_lines()
    {
        var long_ = s_files.Value.Where(file => Lines(file) > MostLines).Select(file => $"{file.Name}: {Lines(file)}").ToList();
        Assert.True(long_.Count == 0, string.Join('\n', long_));
    }

    private static int Lines(SourceFile file) => file.Text.Split('\n').Count(line => !string.IsNullOrWhiteSpace(line));
}
