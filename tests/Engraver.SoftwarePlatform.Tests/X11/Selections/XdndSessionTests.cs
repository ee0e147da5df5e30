using Avalonia.Input.Raw;
using Engraver.SoftwarePlatform.X11.Selections;

namespace Engraver.SoftwarePlatform.Tests.X11.Selections;

public sealed class XdndSessionTests
{
    private const nint Source = 7;
    private readonly RecordingPartner _partner = new();
    private readonly XdndSession _session;

    public XdndSessionTests() => _session = new XdndSession(_partner);

    [Fact]
    public void A_drag_asks_for_the_files_once_and_holds_the_first_status_back()
    {
        _session.Enter(Source, offersFiles: true);
        _session.Position(Source, 10, 20, 1);
        _session.Position(Source, 11, 21, 2);
        Assert.Equal(["files?"], _partner.Calls);

        _session.FilesArrived(["/a.dxf"]);
        _session.Answer(RawDragEventType.DragOver, accepted: true);
        _session.Drop(Source, 3);
        _session.Answer(RawDragEventType.Drop, accepted: true);

        Assert.Equal(["files?", "DragEnter 11,21 /a.dxf", "DragOver 11,21 /a.dxf", "status 7 True", "Drop 11,21 /a.dxf", "finished 7 True"], _partner.Calls);
    }

    [Fact]
    public void A_drop_before_the_files_are_known_waits_for_them()
    {
        _session.Enter(Source, offersFiles: true);
        _session.Position(Source, 1, 2, 1);
        _session.Drop(Source, 2);
        _session.FilesArrived(["/a.dxf"]);

        Assert.Equal(["files?", "DragEnter 1,2 /a.dxf", "DragOver 1,2 /a.dxf", "Drop 1,2 /a.dxf"], _partner.Calls);
    }

    [Fact]
    public void What_is_no_file_is_refused_without_telling_the_window()
    {
        _session.Enter(Source, offersFiles: false);
        _session.Position(Source, 1, 2, 1);
        _session.Drop(Source, 2);

        Assert.Equal(["status 7 False", "finished 7 False"], _partner.Calls);
    }

    [Fact]
    public void A_source_that_gives_no_files_after_all_is_refused()
    {
        _session.Enter(Source, offersFiles: true);
        _session.Position(Source, 1, 2, 1);
        _session.FilesArrived(null);

        Assert.Equal(["files?", "status 7 False"], _partner.Calls);
    }

    [Fact]
    public void Leaving_is_told_and_late_answers_go_nowhere()
    {
        _session.Enter(Source, offersFiles: true);
        _session.Position(Source, 1, 2, 1);
        _session.FilesArrived(["/a.dxf"]);
        _session.Leave();
        _session.Answer(RawDragEventType.DragOver, accepted: true);
        _session.Position(Source, 5, 5, 9);

        Assert.Equal(["files?", "DragEnter 1,2 /a.dxf", "DragOver 1,2 /a.dxf", "DragLeave 1,2 /a.dxf"], _partner.Calls);
    }

    [Fact]
    public void Messages_of_a_stranger_are_not_heard()
    {
        _session.Enter(Source, offersFiles: true);
        _session.Position(8, 1, 2, 1);
        _session.Drop(8, 2);

        Assert.Empty(_partner.Calls);
    }

    private sealed class RecordingPartner : IXdndPartner
    {
        public List<string> Calls { get; } = [];

        public void RequestFiles(nint time) => Calls.Add("files?");

        public void SendToWindow(RawDragEventType type, int rootX, int rootY, IReadOnlyList<string> files) => Calls.Add($"{type} {rootX},{rootY} {string.Join(' ', files)}");

        public void SendStatus(nint source, bool accepted) => Calls.Add($"status {source} {accepted}");

        public void SendFinished(nint source, bool accepted) => Calls.Add($"finished {source} {accepted}");
    }
}
