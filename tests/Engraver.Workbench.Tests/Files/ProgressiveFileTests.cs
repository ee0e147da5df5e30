using Engraver.TestKit;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Files;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Files;

public sealed class ProgressiveFileTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(1000)]
    [InlineData(3_000_001)]
    public void Every_byte_is_where_it_is_in_the_file(int length)
    {
        using var file = new WrittenFile(length);
        using var arriving = ProgressiveFile.TryStart(file.Path, large: 0)!;

        Assert.InRange(arriving.WaitFor(length / 2), length / 2, length);
        Assert.Equal(file.Bytes[..(length / 2)], arriving.Bytes[..(length / 2)]);
        Assert.Equal(length, arriving.WaitFor(length));
        Assert.True(file.Bytes.AsSpan().SequenceEqual(arriving.Bytes));
    }

    [Fact]
    public void A_small_file_and_a_stream_are_better_read_in_one_piece()
    {
        using var file = new WrittenFile(1000);
        Assert.Null(ProgressiveFile.TryStart(file.Path, large: 1000));
        if (OperatingSystem.IsLinux()) Assert.Null(ProgressiveFile.TryStart("/dev/zero", large: 0));
    }

    [Fact]
    public void A_file_that_is_not_there_is_told_as_such() =>
        Assert.Throws<FileNotFoundException>(() => ProgressiveFile.TryStart(Path.Combine(Path.GetTempPath(), Guid.NewGuid().ToString())));

    /// <summary>Another program rewrites it: the part already read is not the drawing.</summary>
    [Fact]
    public void A_file_that_has_become_shorter_meanwhile_is_told_as_such()
    {
        using var file = new WrittenFile(1000);
        using var arriving = new ProgressiveFile(File.OpenHandle(file.Path), 1001);

        Assert.Equal(1000, arriving.WaitFor(1000));
        Assert.Contains("became shorter while it was read", Assert.Throws<IOException>(() => arriving.WaitFor(1001)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Who_waits_hears_why_the_rest_cannot_be_read()
    {
        using var file = new WrittenFile(1000);
        var handle = File.OpenHandle(file.Path, FileMode.Open, FileAccess.Write);
        using var arriving = new ProgressiveFile(handle, 1000);

        Assert.ThrowsAny<IOException>(() => arriving.WaitFor(1));
    }

    /// <summary>Esc on a network share that does not respond.</summary>
    [Fact]
    public async Task Who_waits_is_let_go_when_the_rest_is_not_wanted_any_more()
    {
        using var answers = new ManualResetEventSlim();
        var file = new Closed();
        var arriving = new ProgressiveFile(file, 1000, (_, at) => at == 0 ? 10 : Late());
        Assert.Equal(10, arriving.WaitFor(10));
        var waiting = Task.Run(() => arriving.WaitFor(11));
        arriving.Dispose();
        Assert.Contains("not read completely", (await Assert.ThrowsAsync<IOException>(() => waiting)).Message, StringComparison.Ordinal);
        Assert.Equal(10, arriving.WaitFor(10));

        answers.Set();
        await file.WasClosed.Task;

        int Late()
        {
            answers.Wait();
            return 10;
        }
    }

    [Fact]
    public async Task A_failure_that_nobody_expects_is_told_and_the_file_closed()
    {
        var file = new Closed();
        using var arriving = new ProgressiveFile(file, 1000, (_, at) => at == 0 ? 10 : throw new NotSupportedException("a device"));

        Assert.Contains("not read completely", Assert.Throws<IOException>(() => arriving.WaitFor(11)).Message, StringComparison.Ordinal);
        Assert.Equal(10, arriving.WaitFor(10));
        await file.WasClosed.Task;
    }

    /// <summary>Larger than one chunk.</summary>
    [Fact]
    public async Task A_large_drawing_is_opened_and_one_that_is_given_up_is_no_drawing()
    {
        var path = Path.GetTempFileName();
        var comments = string.Concat(Enumerable.Repeat("999\n" + new string('x', 4000) + "\n", (int)(ProgressiveFile.MinProgressiveLength / 4000)));
        await File.WriteAllTextAsync(path, comments + System.Text.Encoding.UTF8.GetString(DxfText.WithEntities((0, "LINE"), (8, "0"), (10, 1.0), (20, 2.0), (11, 3.0), (21, 4.0)).ToAscii()));

        var drawing = DrawingFile.Open(path, new DrawingSettings(), CancellationToken.None);
        Assert.Equal((1, 4.0, new FileInfo(path).Length), (drawing.Entities.Count, drawing.Parts[0].E, drawing.Bytes));
        Assert.Throws<OperationCanceledException>(() => DrawingFile.Open(path, new DrawingSettings(), new CancellationToken(canceled: true)));
        File.Delete(path);
    }

    private sealed class Closed : IDisposable
    {
        public TaskCompletionSource WasClosed { get; } = new();

        public void Dispose() => WasClosed.SetResult();
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
