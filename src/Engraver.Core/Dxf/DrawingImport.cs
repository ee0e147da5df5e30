using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Blocks;
using Engraver.Core.Dxf.Lengths;
using Engraver.Core.Dxf.Mapping;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Dxf.Tags;
using Engraver.Core.Dxf.Text;

namespace Engraver.Core.Dxf;

/// <summary>Reads one file into a <see cref="Drawing"/>: processes the sections and holds their shared data.</summary>
internal sealed class DrawingImport
{
    private readonly DxfTagSource _tags;
    private readonly DxfReadOptions _options;
    private readonly DxfHeader _header = new();
    private readonly DxfTextDecoder _text = new();
    private readonly ImportLog _log;
    private readonly StyleTable _styles = new();
    private readonly RecordReader _records;
    private readonly ContentReader _content;
    private readonly LayerTable _layers;
    private readonly DefinitionReader _definitions;
    private readonly TextExpander _texts;
    private readonly PointExpander _points;
    private readonly ConstructionTally _construction;
    private readonly CurveColumns _curves = new();
    private readonly LinetypeTable _linetypes;
    private readonly LineStyleTable _lineStyles = new();
    private readonly BlockPathTable _paths = new();
    private readonly BlockExpander _blocks;
    private readonly ReadTally _balance;
    private readonly ModelSpaceContent _modelSpace;
    private readonly List<(int Position, int Line)> _postponed = [];
    private int _sections;
    private bool _skippedSection;
    private int? _lastDefinitions;
    private bool _readTables;
    private bool _readBlocks;

    public DrawingImport(DxfTagSource tags, DxfReadOptions options, CancellationToken cancellation)
    {
        _tags = tags;
        _options = options;
        _log = new ImportLog(tags.IsBinary ? Wording.Get("DrawingImport.Byte") : Wording.Get("DrawingImport.Line"));
        if (tags.IsUtf8) _text.UseUtf8();
        var multiLines = options.Cut.HasFlag(CutChoice.MLine) ? MultiLineStyles.Read(tags, cancellation) : new MultiLineStyles();
        _records = new RecordReader(tags, new NameTable(_text.Decode), new NameTable(_text.Decode), _text.DecodeRaw, options.Cut | options.Areas, _log, cancellation) { Progress = options.Progress };
        _layers = new LayerTable(_records.Layers);
        _linetypes = new LinetypeTable(_records.Linetypes, _layers);
        _content = new ContentReader(_records, new TextMapper(_styles), new OutlineMapper(multiLines), new LengthCheck(_layers), _linetypes, _lineStyles, options.Cut, options.Areas & ~options.Cut);
        _balance = new ReadTally(_log);
        var (blocks, blockCurves) = (new Dictionary<int, BlockDefinition>(), new CurveColumns());
        _definitions = new DefinitionReader(_records, _content, _styles, _layers, _linetypes, blocks, blockCurves, _balance, _log);
        _blocks = new BlockExpander(blocks, _records.Blocks, blockCurves, _curves, _layers, _lineStyles, _paths, _balance, options.MaxExpandedCurves, cancellation);
        _texts = new TextExpander(blocks, _layers, _paths, cancellation);
        _points = new PointExpander(blocks, _layers, _paths, cancellation);
        _construction = new ConstructionTally(blocks, _layers, _paths, cancellation);
        _modelSpace = new ModelSpaceContent(_curves, _blocks, _paths, _texts, _points, _construction, _balance, _log);
    }

    /// <summary>Reads all sections; false when there is none and the file is therefore not a DXF.</summary>
    public bool ReadSections()
    {
        while (_records.Next != RecordKind.FileEnd)
        {
            if (_records.Next == RecordKind.Section) ReadSection();
            else if (_records.Next == RecordKind.SectionEnd) _records.Skip();
            else ReadLoose();
        }

        if (_tags.ZeroBytes() is { Count: > 0 } zeros) _log.Add(DxfRules.ZeroBytes, zeros.Line, _log.Place(zeros.Line), zeros.Count.ToString(CultureInfo.InvariantCulture));
        if (_records.Truncated) _log.Add(_skippedSection && UnreadRemainder.IsHarmless(_tags) ? DxfRules.RestUnreadable : DxfRules.Truncated, _records.NextLine, _log.Place(_records.NextLine));
        foreach (var entities in _postponed)
        {
            _tags.Return(entities);
            ReadEntities();
        }

        foreach (var block in _definitions.ModelSpaceBlocks)
        {
            _tags.Return(block);
            ReadModelSpaceBlock();
        }

        return _sections > 0;
    }

    public Drawing ToDrawing(string fileName, long bytes)
    {
        var unit = Unit();
        if (_texts.LeftOut) _log.Add(DxfRules.TextsLeftOut, 0, _texts.Placed.Count.ToString(CultureInfo.InvariantCulture));
        if (_text.MetForeignBytes) _log.Add(DxfRules.ForeignText, 0, _header.CodePage ?? "UTF-8");
        if (_modelSpace.OnPaper > 0 && _balance.Accepted == 0) _log.Add(DxfRules.AllOnPaper, 0, Wording.Count("Count.Entity", _modelSpace.OnPaper));
        var layers = _layers.ToLayers();
        return new Drawing(fileName, bytes, _header.Version, _tags.IsBinary ? "binary" : "ascii", unit, layers, _curves.Entities, _curves.Parts, _balance.ToReadBalance(layers.Count), _log.ToList())
        {
            Curves = _curves.Curves,
            Texts = _texts.Placed,
            Styles = _styles.ToStyles(),
            Points = _points.Placed,
            PointsRead = _points.Placed.Count,
            Construction = _construction.ToCounts(),
            Cut = _options.Cut,
            Areas = _options.Areas & ~_options.Cut,
            Linetypes = _linetypes.ToLinetypes(),
            LinetypeScale = _header.LinetypeScale,
            LineStyles = _lineStyles.Styles,
            DefaultLineweight = _header.DefaultLineweight,
            Blocks = _records.Blocks.ToList(),
            BlockPaths = _paths.Paths,
            Inserts = _blocks.Inserts,
            HasAllInserts = !_blocks.LeftOut,
        };
    }

    private void ReadSection()
    {
        _sections++;
        _definitions.Finish();
        var name = _records.EnterSection();
        var damages = _tags.DamageCount;
        _skippedSection = name is "OBJECTS" or "ACDSDATA" or "THUMBNAILIMAGE";
        switch (name)
        {
            case "HEADER":
                ReadHeader(damages);
                break;
            case "TABLES":
                ReadDefinitions(name);
                _readTables = true;
                break;
            case "BLOCKS":
                ReadDefinitions(name);
                _readBlocks = true;
                break;
            case "ENTITIES" when IsAheadOfItsBlocks():
                _postponed.Add(_tags.Bookmark());
                do _records.SkipSilently();
                while (!AtSectionEnd());
                break;
            case "ENTITIES":
                ReadEntities();
                break;
            default:
                SkipSection(name, damages);
                break;
        }

        if (_records.Next == RecordKind.SectionEnd) _records.Skip();
        else if (!_records.Truncated) _log.Add(DxfRules.SectionWithoutEnd, _records.NextLine, name, _log.Place(_records.NextLine));
    }

    /// <summary>True when blocks or tables come after these entities (rare). Inserts need their blocks and the state of their layers, so the entities then wait
    /// for a second pass.</summary>
    private bool IsAheadOfItsBlocks()
    {
        if (_readBlocks && _readTables) return false; // the usual order; no need to search the whole file
        // Looked up once: a malicious file may have as many sections as it has lines.
        _lastDefinitions ??= Math.Max(_tags.LastWord("BLOCKS"u8), _tags.LastWord("TABLES"u8));
        return _tags.Bookmark().Position < _lastDefinitions;
    }

    private bool AtSectionEnd() => _records.Next is RecordKind.SectionEnd or RecordKind.Section or RecordKind.FileEnd;

    /// <summary>Skips a section of another program, or one without content to cut. Damage in it is reported, as are records that can only be part of a
    /// drawing.</summary>
    private void SkipSection(string name, int damages)
    {
        var (count, first) = (0, 0);
        for (_records.SkipSilently(); !AtSectionEnd(); _records.SkipSilently())
        {
            if (RecordKinds.IsOfDrawing(_records.Next) && count++ == 0) first = _records.NextLine;
        }

        if (count > 0) _log.Add(DxfRules.SectionPassedOver, first, name, Wording.Count("Count.Record", count), _log.Place(first));
        ReportDamage(name, damages);
    }

    private void ReportDamage(string section, int damages)
    {
        if (_tags.DamageCount != damages && !_tags.IsBinary) _log.Add(DxfRules.DamageBesideCurves, _tags.DamageLine, section, _log.Place(_tags.DamageLine), _tags.DamageText);
    }

    private void ReadHeader(int damages)
    {
        _records.Skip(_header.Take);
        _text.UseVersion(_header.Version);
        ReportDamage("HEADER", damages);
        while (!AtSectionEnd()) _definitions.Take("HEADER");
        if (_header.CodePage is { } name && !_text.UseCodePage(name)) _log.Add(DxfRules.UnknownCodePage, 0, name);
    }

    private void ReadDefinitions(string section)
    {
        for (_records.SkipHead(); !AtSectionEnd();) _definitions.Take(section);
    }

    /// <summary>
    /// Records after a superfluous ENDSEC, or before the first SECTION. Definitions are read; entities continue the block that the ENDSEC interrupted, and
    /// otherwise belong to the drawing. This is reported to the operator.
    /// </summary>
    private void ReadLoose()
    {
        var found = false;
        for (; !AtSectionEnd();)
        {
            if (!RecordKinds.IsEntity(_records.Next))
            {
                if (_records.Next == RecordKind.BlockEnd) _definitions.Finish();
                _definitions.Take("");
                continue;
            }

            if (!found) _log.Add(DxfRules.OutsideOfSections, _records.NextLine, _log.Place(_records.NextLine));
            found = true;
            _content.ReadEntity(_definitions.Unfinished is { } block ? block : _modelSpace);
        }
    }

    private void ReadEntities()
    {
        _records.SkipHead();
        while (!AtSectionEnd()) _content.ReadEntity(_modelSpace);
    }

    /// <summary>Reads the content of the block that is model space last, because its inserts need the blocks after it.</summary>
    private void ReadModelSpaceBlock()
    {
        _records.SkipSilently();
        var (line, before) = (_records.NextLine, _balance.Accepted);
        while (!AtSectionEnd() && _records.Next is not (RecordKind.Block or RecordKind.BlockEnd)) _content.ReadEntity(_modelSpace);
        var taken = _balance.Accepted - before;
        if (taken > 0) _log.Add(DxfRules.ModelSpaceBlock, line, _log.Place(line), Wording.Count("Count.Entity", taken));
    }

    private LengthUnit Unit()
    {
        if (_options.UnitOverride is { } chosen) return chosen with { Source = LengthUnit.Chosen };
        if (LengthUnits.FromInsUnits(_header.InsUnits ?? 0.0) is { } declared) return declared;
        var isInFeet = _header.DisplayUnits is 3.0 or 4.0; // AutoCAD shows such lengths as feet and inches, and a unit of them is an inch
        _log.Add(DxfRules.UnitsAssumed, 0, Shown(_header.InsUnits), Shown(_header.Measurement), isInFeet ? Wording.Get("DrawingImport.InchesAssumed", Shown(_header.DisplayUnits)) : Wording.Get("DrawingImport.MillimetresAssumed"));
        return isInFeet ? LengthUnit.AssumedInches : LengthUnit.AssumedMillimetres;
    }

    private static string Shown(double? variable) => variable?.ToString(CultureInfo.InvariantCulture) ?? Wording.Get("DrawingImport.Missing");
}

/// <summary>
/// The bytes after the position where reading a binary file stopped. AutoCAD's vertical products (Map, Civil) write objects whose values do not have the length
/// of their group codes, so that the data after such a value cannot be located; AutoCAD can, because it calls the object's own code.
/// </summary>
internal static class UnreadRemainder
{
    /// <summary>True when the file is complete (EOF is in it) and all its sections of entities and definitions come before the damage that stopped the
    /// reading.</summary>
    public static bool IsHarmless(DxfTagSource tags)
    {
        if (!tags.IsBinary || tags.DamageCount == 0 || tags.LastWord("EOF"u8) < tags.DamageLine) return false;
        return Math.Max(tags.LastWord("ENTITIES"u8), Math.Max(tags.LastWord("BLOCKS"u8), tags.LastWord("TABLES"u8))) < tags.DamageLine;
    }
}
