using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Tests.Documents;

public class OutputFileTests
{
    [Fact]
    public void A_writer_that_fails_leaves_the_old_file_and_nothing_else()
    {
        var folder = Directory.CreateTempSubdirectory("engraver-test-");
        try
        {
            var path = Path.Combine(folder.FullName, "out.txt");
            OutputFile.Write(path, writer => writer.WriteLine("old"));
            Assert.Throws<InvalidDataException>(() => OutputFile.Write(path, writer =>
            {
                writer.WriteLine("half");
                throw new InvalidDataException();
            }));

            Assert.Equal("old\n", File.ReadAllText(path));
            Assert.Single(folder.GetFiles());
        }
        finally
        {
            folder.Delete(recursive: true);
        }
    }

    [Theory]
    [InlineData("missing/out.txt", "There is no folder ")]
    [InlineData("inner", "That is a folder.")]
    public void A_place_that_cannot_be_written_is_told_without_the_temporary_name(string name, string said)
    {
        var folder = Directory.CreateTempSubdirectory("engraver-test-");
        try
        {
            folder.CreateSubdirectory("inner");
            var refused = Assert.ThrowsAny<IOException>(() => OutputFile.Write(Path.Combine(folder.FullName, name), writer => writer.WriteLine("new")));

            Assert.StartsWith(said, refused.Message, StringComparison.Ordinal);
            Assert.DoesNotContain(".tmp", refused.Message, StringComparison.Ordinal);
            Assert.Empty(folder.GetFiles("*", SearchOption.AllDirectories));
        }
        finally
        {
            folder.Delete(recursive: true);
        }
    }
}
