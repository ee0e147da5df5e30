using Engraver.Workbench.Files;

namespace Engraver.Workbench.Tests.Files;

public sealed class WholeFileTests
{
    /// <summary>In one piece or in parts, also where they are not equal, or more than there are bytes.</summary>
    [Theory]
    [InlineData(0, 1, 3)]
    [InlineData(1, 1, 3)]
    [InlineData(1000, 1000, 2)]
    [InlineData(1_000_003, 1000, 7)]
    [InlineData(1_000_003, 2_000_000, 7)]
    [InlineData(1_000_003, 1000, 1)]
    public void Every_byte_is_where_it_is_in_the_file(int length, long large, int parts)
    {
        var path = Path.GetTempFileName();
        try
        {
            var written = new byte[length];
            new Random(length).NextBytes(written);
            File.WriteAllBytes(path, written);

            Assert.True(written.AsSpan().SequenceEqual(WholeFile.Read(path, large, parts)));
        }
        finally
        {
            File.Delete(path);
        }
    }

    [Fact]
    public void A_file_that_is_not_there_is_told_as_such()
    {
        var path = Path.Combine(Path.GetTempPath(), Guid.NewGuid().ToString());
        Assert.Throws<FileNotFoundException>(() => WholeFile.Read(path, 0, 2));
    }
}
