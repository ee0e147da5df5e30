using Avalonia;
using Avalonia.Controls;
using Engraver.App.Desk;
using Engraver.App.Tabs;

namespace Engraver.App.Shell;

/// <summary>The sizes of the palettes and the pages: dragged by the operator, folded to their strip of tabs, stored between two starts. In a small window
/// they shrink before the canvas does, and grow back; in a very small one they are folded until the operator opens them there.</summary>
public sealed class PanelSizes
{
    private const string HistoryName = "history";
    private const string PagesName = "pages";
    private const string PalettesName = "palettes";

    /// <summary>The strip of tabs, and the row with the last message.</summary>
    private const double FoldedPagesHeight = 29 + 24;
    private const double FoldedPalettesWidth = 30;
    private const double MinPagesHeight = 110;
    private const double MinPalettesWidth = 240;
    private const double DefaultHistoryHeight = 420;

    /// <summary>Minimum room beside the panels, units of 1/96 inch: in height for the canvas and the playback bar, in width for the canvas and the tools in
    /// several columns.</summary>
    private const double MinCanvasHeight = 140;
    private const double MinCanvasWidth = 340;
    private const double SplitterSize = 4;

    /// <summary>Part of the window that widened palettes get.</summary>
    private const double WidePart = 0.62;

    /// <summary>With less room for canvas and panels, the pages or the palettes are folded.</summary>
    private const double MinHeightForPages = 380;
    private const double MinWidthForPalettes = 900;
    private readonly DesktopModel _desk;
    private readonly RowDefinition _pagesRow;
    private readonly ColumnDefinition _palettesColumn;
    private readonly PageTabs _pages;
    private readonly PageTabs _palettes;
    private readonly Grid _columns;
    private bool _isExpanded;
    private bool _isWide;
    private bool _isLow;
    private bool _isNarrow;

    /// <param name="room">Contains the rows and columns, and the command line.</param>
    /// <param name="rows">Rows of canvas, splitter and pages.</param>
    /// <param name="columns">Columns of tools, canvas, splitter and palettes.</param>
    public PanelSizes(DesktopModel desk, Control room, Grid rows, Grid columns, PageTabs pages, PageTabs palettes)
    {
        (_desk, _pagesRow, _palettesColumn, _pages, _palettes) = (desk, rows.RowDefinitions[^1], columns.ColumnDefinitions[^1], pages, palettes);
        _columns = columns;
        rows.SizeChanged += (_, e) => _pagesRow.MaxHeight = Math.Max(MinPagesHeight, e.NewSize.Height - SplitterSize - MinCanvasHeight);
        columns.SizeChanged += (_, e) => _palettesColumn.MaxWidth = Math.Max(MinPalettesWidth, e.NewSize.Width - SplitterSize - MinCanvasWidth);
        room.SizeChanged += (_, e) => FitTo(e.NewSize);
        pages.FoldRequested += (_, _) => FoldPages();
        palettes.FoldRequested += (_, _) => FoldPalettes();
        palettes.WidenRequested += (_, _) => WidenPalettes();
        ShowPages();
        ShowPalettes();
    }

    /// <summary>Only the strip of tabs of the pages is visible.</summary>
    public bool ArePagesFolded => IsFolded(PagesName);

    public void FoldPages()
    {
        Fold(PagesName);
        ShowPages();
    }

    public void FoldPalettes()
    {
        Fold(PalettesName);
        ShowPalettes();
    }

    /// <summary>Gives the palettes most of the window beside the canvas, without the pages below, or restores both sizes.</summary>
    public void WidenPalettes()
    {
        if (IsFolded(PalettesName)) FoldPalettes();
        if (!_isWide) Save();
        var widens = !_isWide;
        ShowPages();
        ShowPalettes();
        if (!widens) return;
        _palettesColumn.Width = new GridLength(Math.Max(MinPalettesWidth, WidePart * _columns.Bounds.Width));
        _pagesRow.MinHeight = FoldedPagesHeight;
        _pagesRow.Height = new GridLength(FoldedPagesHeight);
        _isWide = true;
    }

    /// <summary>Brings the history to the front when something is typed; folded pages stay folded, and the command line shows the last line.</summary>
    public void ShowHistory() => _pages.Show("Command");

    /// <summary>F2: enlarges the history, or restores its height. Both heights are remembered.</summary>
    public void ExpandHistory()
    {
        ShowHistory();
        if (ArePagesFolded) FoldPages();
        Save();
        _isExpanded = !_isExpanded;
        var usual = SizeOf(PagesName, DefaultPagesHeight);
        _pagesRow.Height = new GridLength(_isExpanded ? Math.Max(usual, SizeOf(HistoryName, DefaultHistoryHeight)) : usual);
    }

    /// <summary>Ctrl+0: folds all panels around the canvas, or opens them again.</summary>
    public void FoldAll()
    {
        var (pages, palettes) = (IsFolded(PagesName), IsFolded(PalettesName));
        var unfolds = pages && palettes;
        if (pages == unfolds) FoldPages();
        if (palettes == unfolds) FoldPalettes();
    }

    /// <summary>Stores the present sizes.</summary>
    public void Save() => _desk.Session.Settings.Change(settings =>
    {
        if (_isWide) return settings;
        if (!IsFolded(PagesName)) settings = settings.WithPanelSize(_isExpanded ? HistoryName : PagesName, _pagesRow.Height.Value);
        if (!IsFolded(PalettesName)) settings = settings.WithPanelSize(PalettesName, _palettesColumn.Width.Value);
        return settings;
    });

    private const double DefaultPagesHeight = 164;
    private const double DefaultPalettesWidth = 380;

    private bool IsSmall(string panel) => panel == PagesName ? _isLow : _isNarrow;

    private bool IsFolded(string panel) => _desk.Session.Settings.Current is var settings && IsSmall(panel) ? !settings.PanelsOpenWhenSmall.Contains(panel) : settings.FoldedPanels.Contains(panel);

    /// <summary>Folds or opens a panel, for windows as small as this one or for all others.</summary>
    private void Fold(string panel)
    {
        Save();
        var folds = !IsFolded(panel);
        _desk.Session.Settings.Change(settings => IsSmall(panel) ? settings.WithPanelOpenWhenSmall(panel, !folds) : settings.WithPanelFolded(panel, folds));
    }

    private void FitTo(Size room)
    {
        var (low, narrow) = (room.Height < MinHeightForPages, room.Width < MinWidthForPalettes);
        if (low == _isLow && narrow == _isNarrow) return;
        Save();
        (_isLow, _isNarrow) = (low, narrow);
        ShowPages();
        ShowPalettes();
    }

    private double SizeOf(string panel, double otherwise) => _desk.Session.Settings.Current.PanelSizes.GetValueOrDefault(panel, otherwise);

    private void ShowPages()
    {
        var folded = ArePagesFolded;
        (_isExpanded, _isWide) = (false, false);
        _pagesRow.MinHeight = folded ? FoldedPagesHeight : MinPagesHeight;
        _pagesRow.Height = new GridLength(folded ? FoldedPagesHeight : SizeOf(PagesName, DefaultPagesHeight));
        _pages.ShowFolded(folded, "FoldUpIcon", "FoldDownIcon");
    }

    private void ShowPalettes()
    {
        var folded = IsFolded(PalettesName);
        _isWide = false;
        _palettesColumn.MinWidth = folded ? FoldedPalettesWidth : MinPalettesWidth;
        _palettesColumn.Width = new GridLength(folded ? FoldedPalettesWidth : SizeOf(PalettesName, DefaultPalettesWidth));
        _palettes.ShowFolded(folded, "FoldLeftIcon", "FoldRightIcon");
        _palettes.HideStrip(folded);
    }
}
