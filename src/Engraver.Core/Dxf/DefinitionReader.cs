using Engraver.Core.Diagnostics;
using Engraver.Core.Dxf.Blocks;
using Engraver.Core.Dxf.Mapping;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf;

/// <summary>Reads the definitions to which entities refer: the layers and text styles of TABLES, the blocks of BLOCKS.</summary>
internal sealed class DefinitionReader(
    RecordReader records, ContentReader content, StyleTable styles, LayerTable layers, LinetypeTable linetypes, Dictionary<int, BlockDefinition> blocks, CurveColumns curves, ReadTally balance, ImportLog log)
{
    /// <summary>Flags of an external reference (4) or an overlaid one (8): its drawing is another file.</summary>
    private const int ExternalFlags = 4 | 8;

    private readonly EntityRecord _record = new();

    /// <summary>The block whose section ended before its ENDBLK; null when there is none.</summary>
    public BlockContent? Unfinished { get; private set; }

    /// <summary>Where the blocks of model space begin, if they are not empty: some programs write the drawing there and not in ENTITIES.</summary>
    public List<(int Position, int Line)> ModelSpaceBlocks { get; } = [];

    /// <summary>Reads a definition; any other record is skipped, and reported when it does not belong in the section.</summary>
    /// <param name="section">HEADER, TABLES, BLOCKS, or "" outside of every section.</param>
    public void Take(string section)
    {
        if (records.Next == RecordKind.Block) TakeBlock();
        else if (records.Next is RecordKind.LayerEntry or RecordKind.StyleEntry or RecordKind.LinetypeEntry) TakeTableEntry();
        else SkipSection(section);
    }

    private void SkipSection(string section)
    {
        var misplaced = section switch
        {
            "TABLES" => !RecordKinds.IsOfTables(records.NextType),
            "HEADER" or "BLOCKS" => RecordKinds.IsOfDrawing(records.Next) && records.Next != RecordKind.BlockEnd,
            _ => false,
        };
        if (misplaced) log.Add(new RecordIssue(DxfRules.MisplacedRecord, records.NextType, 0, records.NextLine, section, Refused: true));
        records.Skip();
    }

    /// <summary>Discards the unfinished block: no record that follows belongs to it.</summary>
    public void Finish() => Unfinished = null;

    private void TakeTableEntry()
    {
        records.Read(_record);
        if (_record.Kind == RecordKind.StyleEntry) styles.Define(_record);
        else if (_record.Kind == RecordKind.LinetypeEntry) linetypes.Define(_record);
        else if (_record.Fault is { } fault) log.Add(fault);
        else if (_record.Name >= 0) layers.Define(_record);
    }

    private void TakeBlock()
    {
        var start = records.Bookmark();
        records.Read(_record);
        if (_record.Name >= 0 && IsModelSpace(records.Blocks[_record.Name]))
        {
            SkipModelSpace(start);
            return;
        }

        var basePoint = new Vector3D(_record.Number(10, 0.0), _record.Number(20, 0.0), _record.Number(30, 0.0));
        var block = new BlockDefinition(_record.Name < 0 ? "" : records.Blocks[_record.Name], basePoint, curves.Count);
        var target = new BlockContent(block, curves, balance);
        while (!EndsBlock()) content.ReadEntity(target);
        Unfinished = records.Next == RecordKind.SectionEnd ? target : null;
        if (records.Next == RecordKind.BlockEnd) records.Skip();
        Define(block);
    }

    /// <summary>True for the block of model space, as R13 and later name it, and R12 when written by later releases.</summary>
    private static bool IsModelSpace(string block) => block.Equals("*MODEL_SPACE", StringComparison.OrdinalIgnoreCase) || block.Equals("$MODEL_SPACE", StringComparison.OrdinalIgnoreCase);

    private void SkipModelSpace((int Position, int Line) start)
    {
        if (_record.Fault is { } fault) log.Add(fault);
        if (!EndsBlock()) ModelSpaceBlocks.Add(start);
        while (!EndsBlock()) records.SkipSilently();
        if (records.Next == RecordKind.BlockEnd) records.Skip();
    }

    private bool EndsBlock() => records.Next is RecordKind.Block or RecordKind.BlockEnd or RecordKind.SectionEnd or RecordKind.Section or RecordKind.FileEnd;

    /// <summary>Adds a block. An external reference without content is not added, because its drawing is in another file: its inserts are then refused instead
    /// of drawing nothing.</summary>
    private void Define(BlockDefinition block)
    {
        if (_record.Fault is { } fault) balance.AddInBlock(fault);
        else if (_record.Name < 0 || ((_record.Flags(70) & ExternalFlags) != 0 && block.IsEmpty)) return;
        else if (!blocks.TryAdd(_record.Name, block)) log.Add(_record.Finding(DxfRules.BlockTwice, block.Name, refused: false));
    }
}
