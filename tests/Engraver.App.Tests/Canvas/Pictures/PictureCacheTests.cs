using Avalonia;
using Engraver.App.Canvas.Colours;
using Engraver.App.Canvas.Pictures;
using Engraver.App.Canvas.Rasterising;
using Engraver.App.Canvas.Scenes;
using Engraver.App.Canvas.Views;
using Engraver.Core.Geometry;
using Engraver.Workbench.Views;

namespace Engraver.App.Tests.Canvas.Pictures;

public class PictureCacheTests
{
    private static readonly PixelSize s_size = new(320, 240);
    private static readonly CanvasView s_view = new(new Point2D(50.0, 50.0), 0.5, s_size);
    private static readonly CanvasContent s_content = new() { Scene = CanvasScene.From(RandomDrawings.Of(seed: 2, count: 200)), Grid = false };

    [Fact]
    public void Before_the_first_picture_there_is_the_background()
    {
        var keeper = new PictureCache { Content = s_content, View = s_view };

        Assert.False(keeper.IsUpToDate);
        Assert.All(Shown(keeper), pixel => Assert.Equal(CanvasTheme.Dark.Background, pixel));
    }

    [Fact]
    public void A_picture_panned_by_whole_pixels_is_the_fresh_one_where_both_are()
    {
        var keeper = Refined(s_view);

        keeper.View = s_view.PannedBy(new Vector2D(32.0, -16.0));
        var (moved, fresh) = (Shown(keeper), Fresh(keeper.View));

        Assert.False(keeper.IsUpToDate);
        for (var y = 0; y < s_size.Height - 16; y++)
        {
            for (var x = 32; x < s_size.Width; x++) Assert.Equal(fresh[(y * s_size.Width) + x], moved[(y * s_size.Width) + x]);
        }

        Assert.All(Enumerable.Range(0, s_size.Height), y => Assert.Equal(CanvasTheme.Dark.Background, moved[(y * s_size.Width) + 31]));
    }

    [Fact]
    public void A_zoomed_picture_keeps_the_pixel_under_the_cursor()
    {
        var keeper = Refined(s_view);
        var before = Shown(keeper);
        var lit = Enumerable.Range(0, before.Length).First(i => before[i] == 0xFFFFFFFF && i % s_size.Width > 40 && i / s_size.Width > 40);
        var cursor = new Point2D((lit % s_size.Width) + 0.5, (lit / s_size.Width) + 0.5);

        keeper.View = s_view.ZoomedAbout(cursor, 3.0);

        Assert.Equal(0xFFFFFFFF, Shown(keeper)[lit]);
    }

    [Fact]
    public async Task After_refining_the_moved_picture_is_exactly_the_fresh_one()
    {
        var keeper = Refined(s_view);
        keeper.View = s_view.ZoomedAbout(new Point2D(10.0, 20.0), 1.7).PannedBy(new Vector2D(3.3, 4.4));
        var refined = 0;
        keeper.Refined += (_, _) => refined++;

        Assert.True(await keeper.RefineAsync());

        Assert.True(keeper.IsUpToDate);
        Assert.Equal(1, refined);
        Assert.Equal(Fresh(keeper.View), Shown(keeper));
    }

    [Fact]
    public async Task An_abandoned_picture_is_not_taken()
    {
        var keeper = Refined(s_view);
        var before = Shown(keeper);
        keeper.View = s_view.PannedBy(new Vector2D(100.0, 0.0));

        var window = new BusyWindow();
        var refining = window.Run(keeper.RefineAsync);
        keeper.CancelDrawing();
        window.RunPosted();

        Assert.False(await refining);
        Assert.False(keeper.IsUpToDate);
        keeper.View = s_view;
        Assert.Equal(before, Shown(keeper));
    }

    [Fact]
    public void Other_content_is_not_fresh_even_in_the_same_view()
    {
        var keeper = Refined(s_view);

        keeper.Content = s_content with { Shown = CanvasLayers.None };

        Assert.False(keeper.IsUpToDate);
        keeper.Refine(CancellationToken.None);
        Assert.All(Shown(keeper), pixel => Assert.Equal(CanvasTheme.Dark.Background, pixel));
    }

    /// <summary>The thread of a busy window: posted continuations run only when it is idle again, even if the picture is done earlier.</summary>
    private sealed class BusyWindow : SynchronizationContext
    {
        private readonly List<Action> _waiting = [];
        private bool _atRest;

        public T Run<T>(Func<T> work)
        {
            var before = Current;
            SetSynchronizationContext(this);
            try
            {
                return work();
            }
            finally
            {
                SetSynchronizationContext(before);
            }
        }

        public override void Post(SendOrPostCallback d, object? state)
        {
            lock (_waiting)
            {
                if (!_atRest)
                {
                    _waiting.Add(() => d(state));
                    return;
                }
            }

            d(state);
        }

        public void RunPosted()
        {
            lock (_waiting) _atRest = true;
            foreach (var action in _waiting) action();
        }
    }

    private static PictureCache Refined(CanvasView view)
    {
        var keeper = new PictureCache { Content = s_content, View = view };
        keeper.Refine(CancellationToken.None);
        return keeper;
    }

    private static uint[] Shown(PictureCache keeper)
    {
        var pixels = new uint[s_size.Width * s_size.Height];
        keeper.Show(pixels, s_size.Width);
        return pixels;
    }

    private static uint[] Fresh(CanvasView view) =>
        PictureRenderer.Render(LayerStack.Create(s_content, view), view, Backdrop.For(view, s_content.Theme, s_content.Grid), CancellationToken.None).Pixels;
}
