using Engraver.Workbench.Files;

namespace Engraver.Workbench.Tests.Files;

public sealed class ArrivingFileTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(1000)]
    [InlineData(3_000_001)]
    public void Every_byte_is_where_it_is_in_the_file(int length)
    {
        using var file = new WrittenFile(length);
        using var arriving = ArrivingFile.TryBegin(file.Path, large: 0)!;

        Assert.InRange(arriving.WaitFor(length / 2), length / 2, length);
        Assert.Equal(file.Bytes[..(length / 2)], arriving.Bytes[..(length / 2)]);
        Assert.Equal(length, arriving.WaitFor(length));
        Assert.True(file.Bytes.AsSpan().SequenceEqual(arriving.Bytes));
    }

    [Fact]
    public void A_small_file_and_a_stream_are_better_read_in_one_piece()
    {
        using var file = new WrittenFile(1000);
        Assert.Null(ArrivingFile.TryBegin(file.Path, large: 1000));
        if (OperatingSystem.IsLinux()) Assert.Null(ArrivingFile.TryBegin("/dev/zero", large: 0));
    }

    [Fact]
    public void A_file_that_is_not_there_is_told_as_such() =>
        Assert.Throws<FileNotFoundException>(() => ArrivingFile.TryBegin(Path.Combine(Path.GetTempPath(), Guid.NewGuid().ToString())));

    /// <summary>Another program writes it anew: what was there of it is not the drawing.</summary>
    [Fact]
    public void A_file_that_has_become_shorter_meanwhile_is_told_as_such()
    {
        using var file = new WrittenFile(1000);
        using var arriving = new ArrivingFile(File.OpenHandle(file.Path), 1001);

        Assert.Equal(1000, arriving.WaitFor(1000));
        Assert.Contains("became shorter while it was read", Assert.Throws<IOException>(() => arriving.WaitFor(1001)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Who_waits_hears_why_the_rest_cannot_be_read()
    {
        using var file = new WrittenFile(1000);
        var handle = File.OpenHandle(file.Path, FileMode.Open, FileAccess.Write);
        using var arriving = new ArrivingFile(handle, 1000);

        Assert.ThrowsAny<IOException>(() => arriving.WaitFor(1));
    }

    private sealed class WrittenFile : IDisposable
    {
        public WrittenFile(int length)
        {
            Bytes = new byte[length];
            new Random(length).NextBytes(Bytes);
            File.WriteAllBytes(Path, Bytes);
        }

        public byte[] Bytes { get; }

        public string Path { get; } = System.IO.Path.GetTempFileName();

        public void Dispose() => File.Delete(Path);
    }
}
