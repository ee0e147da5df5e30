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
}
