using Engraver.Workbench.Files;

namespace Engraver.Workbench.Tests.Files;

/// <summary>A result is complete or missing, also if the program ends while writing it.</summary>
public sealed class TemporaryFileTests : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-test-");

    private string Target => Path.Combine(_folder.FullName, "out.txt");

    public void Dispose() => _folder.Delete(recursive: true);

    [Fact]
    public void When_the_process_ends_in_the_middle_the_old_file_stands_and_nothing_else()
    {
        File.WriteAllText(Target, "old");
        using var temporary = new TemporaryFile(Target);
        using (var half = temporary.Create())
        {
            half.Write("half"u8);
            half.Flush();
            Assert.Equal(2, _folder.GetFiles().Length);
            temporary.End();
            half.Write("whole"u8);
        }

        Assert.ThrowsAny<IOException>(temporary.ReplaceTarget);
        Assert.Equal("old", File.ReadAllText(Target));
        Assert.Single(_folder.GetFiles());
    }

    [Fact]
    public void When_the_process_has_ended_nothing_is_begun()
    {
        using var temporary = new TemporaryFile(Target);
        temporary.End();

        Assert.Throws<OperationCanceledException>(() => temporary.Create());
        Assert.Empty(_folder.GetFiles());
    }
}
