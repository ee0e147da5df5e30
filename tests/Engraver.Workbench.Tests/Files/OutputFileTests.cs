using Engraver.Workbench.Files;

namespace Engraver.Workbench.Tests.Files;

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
    [InlineData("missing/out.txt", "Folder ")]
    [InlineData("inner", "The path is a folder.")]
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

    [Fact]
    public void A_link_stays_a_link_and_what_it_leads_to_is_written()
    {
        if (OperatingSystem.IsWindows()) return; // Creating links requires a privilege there.
        var folder = Directory.CreateTempSubdirectory("engraver-test-");
        try
        {
            var (real, link) = (Path.Combine(folder.FullName, "real.txt"), Path.Combine(folder.FullName, "link.txt"));
            File.WriteAllText(real, "old");
            File.CreateSymbolicLink(link, real);
            OutputFile.Write(link, writer => writer.WriteLine("new"));

            Assert.Equal(real, new FileInfo(link).LinkTarget);
            Assert.Equal("new\n", File.ReadAllText(real));
        }
        finally
        {
            folder.Delete(recursive: true);
        }
    }

    [Theory]
    [InlineData("/dev/null", false)]
    [InlineData("/dev/full", true)]
    public void A_device_is_written_and_not_replaced_by_a_file(string device, bool isFull)
    {
        if (OperatingSystem.IsWindows()) return;
        var folder = Directory.CreateTempSubdirectory("engraver-test-");
        try
        {
            // Through a link, so that a mistake replaces the link and not the device.
            var link = Path.Combine(folder.FullName, "device");
            File.CreateSymbolicLink(link, device);
            var failure = Record.Exception(() => OutputFile.Write(link, writer => writer.WriteLine("text")));

            Assert.Equal(isFull, failure is IOException);
            Assert.Equal(device, new FileInfo(link).LinkTarget);
            Assert.Single(folder.GetFileSystemInfos());
        }
        finally
        {
            folder.Delete(recursive: true);
        }
    }
}
